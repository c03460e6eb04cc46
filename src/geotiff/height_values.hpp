#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "geotiff/geotiff_driver.hpp"
#include "geotiff/height_raster.hpp"

namespace groundgrid::geotiff {

/// How many metres one step of the first band is: of the unit given, else of the one that the band
/// names, else of the vertical CRS, else metres. Throws io::Error where the band's unit is no
/// length that is known here, or it names none and the CRS counts in feet on the ground.
double metres_per_unit(const std::filesystem::path& path, GDALDataset& raster,
                       std::optional<LengthUnit> unit);

/// Turns the numbers of a raster's first band into metres. Throws io::Error as above, and where
/// one is no height that a place on Earth has.
void to_metres(const std::filesystem::path& path, GDALDataset& raster,
               std::optional<LengthUnit> unit, std::vector<float>& heights);

}  // namespace groundgrid::geotiff
