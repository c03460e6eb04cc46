#pragma once

#include <string_view>

namespace groundgrid::program {

/// Writes a result to standard output. Throws io::Error where it does not take all of it (a full
/// disk, a closed pipe).
void print_result(std::string_view text);

}  // namespace groundgrid::program
