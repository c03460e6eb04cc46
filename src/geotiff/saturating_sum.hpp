#pragma once

#include <cstdint>
#include <limits>

namespace groundgrid::geotiff {

/// The sum, or the greatest value where it does not fit.
inline std::uint32_t saturating_sum(std::uint32_t a, std::uint32_t b) {
  const std::uint32_t sum = a + b;
  return sum < a ? std::numeric_limits<std::uint32_t>::max() : sum;
}

}  // namespace groundgrid::geotiff
