#pragma once

#include <cstddef>

namespace groundgrid::testing {

/// How often this program has called any operator new.
std::size_t allocations();

}  // namespace groundgrid::testing
