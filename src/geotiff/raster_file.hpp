#pragma once

#include <filesystem>
#include <string>

#include "geotiff/geotiff_driver.hpp"
#include "geotiff/height_raster.hpp"

namespace groundgrid::geotiff {

/// Opens a GeoTIFF for reading. Throws io::Error where that fails, it has no band, or does not say
/// where it lies.
DatasetPtr open_raster(const std::filesystem::path& path);

/// Where its pixels lie.
RasterFrame frame_of(GDALDataset& raster);

/// The numbers of a band without its holes, in which every number is to be scaled and shifted.
struct LinearValues {
  double scale = 1.0;
  double offset = 0.0;
};
LinearValues linear_values(GDALRasterBand& band);

/// Throws io::Error with GDAL's words for a file that cannot be read.
[[noreturn]] void fail_to_read(const std::filesystem::path& path, const std::string& words);

}  // namespace groundgrid::geotiff
