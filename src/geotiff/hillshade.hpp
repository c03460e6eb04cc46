#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace groundgrid::geotiff {

/// A terrain to be lit: heights row by row from the north, NaN where there is none.
struct ShadedCells {
  int columns = 0;
  int rows = 0;
  double cell_width_m = 0.0;
  double cell_height_m = 0.0;
  std::span<const float> heights_m{};
};

/// What hillshade() gives to level ground: 1 + 254 times the sine of the sun's height of 45°.
inline constexpr std::uint8_t kLevelShade = 181;

/// How light each cell is under a sun in the north-west, 1 to 255; 0 where there is no height.
/// Slopes are taken `exaggeration` times as steep. Throws std::runtime_error where GDAL fails,
/// std::invalid_argument where there is not one height a cell.
std::vector<std::uint8_t> hillshade(const ShadedCells& cells, double exaggeration);

}  // namespace groundgrid::geotiff
