#pragma once

#include <filesystem>
#include <span>

#include "geotiff/raster_grid.hpp"

namespace groundgrid::geotiff {

/// Writes heights as a GeoTIFF of one band in a local frame: north-up, DEFLATE, tiled. `heights`
/// holds the grid's cells row by row from the south, metres; kNoData stands for an unknown one.
/// Complete or not at all. Throws io::Error where the file cannot be written and
/// std::invalid_argument where there are not columns × rows heights.
void write_heights(const std::filesystem::path& path, const RasterGrid& grid,
                   std::span<const float> heights);

}  // namespace groundgrid::geotiff
