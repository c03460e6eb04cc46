#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace groundgrid {

/// Appends, ascending, every cell whose byte has the bit of `mark` to `found`.
void append_marked(std::span<const std::uint8_t> cells, std::uint8_t mark,
                   std::vector<std::uint32_t>& found);

}  // namespace groundgrid
