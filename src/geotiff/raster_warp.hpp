#pragma once

#include <filesystem>
#include <vector>

#include "geotiff/geotiff_driver.hpp"
#include "geotiff/height_raster.hpp"

namespace groundgrid::geotiff {

/// How the values between the middles of pixels are found.
enum class Resampling : std::uint8_t {
  nearest,
  smooth  ///< The mean of the pixels in the target's where they are smaller, else bilinear.
};

/// The first band of a raster on the pixels of a frame, NaN where it has no value. Where one of
/// both has no CRS, it is taken to be in that of the other. Throws io::Error where it cannot be
/// read, its CRS cannot be transformed, or it has no value within the frame.
std::vector<float> warp_band(const std::filesystem::path& path, GDALDataset& raster,
                             const RasterFrame& onto, Resampling resampling);

}  // namespace groundgrid::geotiff
