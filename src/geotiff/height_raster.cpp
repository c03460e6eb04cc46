#include "geotiff/height_raster.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string_view>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/height_values.hpp"
#include "geotiff/raster_file.hpp"
#include "io/error.hpp"

namespace groundgrid::geotiff {
namespace {

// At 0.33 m cells a square of 3.3 km; every layer of it takes 400 MB.
constexpr double kMostPixels = 1e8;

void check_size(const std::filesystem::path& path, const RasterFrame& frame) {
  if (static_cast<double>(frame.columns) * static_cast<double>(frame.rows) <= kMostPixels) return;
  throw io::Error({.file = path,
                   .expected = fmt::format("at most {:.0f} million pixels", kMostPixels / 1e6),
                   .got = fmt::format("{} x {}", frame.columns, frame.rows),
                   .remedy = "cut a part out of it with gdal_translate -srcwin"});
}

// Distances and slopes are those of metres along rows and columns.
void check_pixels(const std::filesystem::path& path, const RasterFrame& frame) {
  const std::array<double, 6>& t = frame.transform;
  const bool straight = t[2] == 0.0 && t[4] == 0.0 && t[1] != 0.0 && t[5] != 0.0;
  if (straight && std::isfinite(t[1]) && std::isfinite(t[5])) return;
  throw io::Error({.file = path,
                   .expected = "rows that run from west to east",
                   .got = "a raster that is turned or has no extent",
                   .remedy = "gdalwarp turns it"});
}

void check_crs(const std::filesystem::path& path, const OGRSpatialReference* crs) {
  if (crs == nullptr || crs->IsEmpty() || crs->IsLocal() != 0) return;
  if (crs->IsProjected() != 0 && crs->GetLinearUnits() == 1.0) return;
  throw io::Error({.file = path,
                   .expected = "a terrain that is projected in metres",
                   .got = fmt::format("the system '{}'", crs->GetName()),
                   .remedy = "gdalwarp -t_srs brings it into one such as UTM (EPSG:32632)"});
}

void set_holes(GDALRasterBand& mask, std::vector<float>& values) {
  const int columns = mask.GetXSize();
  std::vector<std::uint8_t> row(static_cast<std::size_t>(columns));
  for (int y = 0; y < mask.GetYSize(); ++y) {
    if (mask.RasterIO(GF_Read, 0, y, columns, 1, row.data(), columns, 1, GDT_Byte, 0, 0, nullptr) !=
        CE_None)
      return;  // The listener has heard why.
    const std::size_t first = static_cast<std::size_t>(y) * row.size();
    for (std::size_t x = 0; x < row.size(); ++x)
      if (row[x] == 0) values[first + x] = std::numeric_limits<float>::quiet_NaN();
  }
}

std::vector<float> read_band(const std::filesystem::path& path, GDALRasterBand& band) {
  const GdalErrors errors;
  const int columns = band.GetXSize();
  const int rows = band.GetYSize();
  std::vector<float> values(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, values.data(), columns, rows, GDT_Float32, 0, 0,
                    nullptr) == CE_None)
    set_holes(*band.GetMaskBand(), values);
  if (!errors.first().empty()) fail_to_read(path, errors.first());
  return values;
}

std::vector<float> read_band_named(const std::filesystem::path& path, GDALDataset& raster,
                                   std::string_view name) {
  for (int index = 1; index <= raster.GetRasterCount(); ++index) {
    GDALRasterBand& band = *raster.GetRasterBand(index);
    if (band.GetDescription() == name) return read_band(path, band);
  }
  return {};
}

}  // namespace

HeightRaster read_height_raster(const std::filesystem::path& path) {
  const DatasetPtr raster = open_raster(path);
  HeightRaster result;
  result.frame = frame_of(*raster);
  check_size(path, result.frame);
  check_pixels(path, result.frame);
  check_crs(path, raster->GetSpatialRef());
  result.heights_m = read_band(path, *raster->GetRasterBand(1));
  to_metres(path, *raster, {}, result.heights_m);
  result.count = read_band_named(path, *raster, "count");
  result.density = read_band_named(path, *raster, "density");
  result.deviation_m = read_band_named(path, *raster, "standard deviation");
  return result;
}

}  // namespace groundgrid::geotiff
