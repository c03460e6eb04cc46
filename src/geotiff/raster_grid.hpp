#pragma once

#include <cstdint>

namespace groundgrid::geotiff {

/// Where the cells of a raster lie. Metres, in the map frame.
struct RasterGrid {
  double min_x_m = 0.0;  ///< Outer edge of the western column.
  double min_y_m = 0.0;  ///< Outer edge of the southern row.
  double resolution_m = 0.0;
  std::int64_t columns = 0;
  std::int64_t rows = 0;
};

}  // namespace groundgrid::geotiff
