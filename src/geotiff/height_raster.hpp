#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace groundgrid::geotiff {

/// What the heights of a raster are counted in.
enum class LengthUnit : std::uint8_t { metre, foot, us_survey_foot };

/// Where the pixels of a raster lie.
struct RasterFrame {
  int columns = 0;
  int rows = 0;
  /// GDAL's: the outer corner of pixel (column, row) is at x = t[0] + column · t[1] + row · t[2],
  /// y = t[3] + column · t[4] + row · t[5].
  std::array<double, 6> transform{};
  std::string crs{};  ///< WKT; empty for a local frame.
};

/// A terrain in its own pixels, row by row as in the file, NaN where there is no value.
struct HeightRaster {
  RasterFrame frame{};
  std::vector<float> heights_m{};  ///< Band 1.
  std::vector<float> count{};      ///< Of the band of that name (terrain_raster.hpp), else empty.
  std::vector<float> density{};    ///< The same.
  /// Of the band "standard deviation", metres; the same.
  std::vector<float> deviation_m{};
};

/// Reads a GeoTIFF whose first band holds heights. They are turned into metres where the band or
/// the vertical CRS says feet.
///
/// Throws io::Error where the file cannot be read, has more than 100 million pixels, does not say
/// where it lies, is turned or sheared, is not projected in metres, or holds heights in a unit that
/// is not known or that no place on Earth has.
HeightRaster read_height_raster(const std::filesystem::path& path);

/// Heights of another raster, one a pixel of a frame, NaN where it has none.
struct ResampledHeights {
  std::vector<float> heights_m{};
  std::vector<std::string> remarks{};  ///< What was taken for granted, one sentence each.
};

/// Brings the first band of a GeoTIFF onto the pixels of a frame, whatever its own pixels and CRS:
/// the mean of those in a pixel where they are smaller, else bilinear. Holes stay holes. Heights
/// are turned into metres; `unit` is for rasters that do not say theirs, and goes before what they
/// say. Differences between vertical datums are not corrected. Where one of both has no CRS, it is
/// taken to be in that of the other, with a remark.
///
/// Throws io::Error where the file cannot be read, does not say where it lies, its CRS cannot be
/// transformed, it has no height within the frame, or its heights are in a unit that is not known
/// or that no place on Earth has.
ResampledHeights resample_heights(const std::filesystem::path& path, const RasterFrame& onto,
                                  std::optional<LengthUnit> unit = {});

/// Brings the first band of a GeoTIFF onto the pixels of a frame, each taking the nearest value;
/// NaN where there is none. Errors as above.
std::vector<float> resample_mask(const std::filesystem::path& path, const RasterFrame& onto);

}  // namespace groundgrid::geotiff
