#include "geotiff/raster_file.hpp"

#include <array>
#include <system_error>

#include "geotiff/gdal_errors.hpp"
#include "io/error.hpp"

namespace groundgrid::geotiff {
namespace {

std::string wkt_of(const OGRSpatialReference* crs) {
  if (crs == nullptr || crs->IsEmpty()) return {};
  char* text = nullptr;
  const std::array<const char*, 2> options{"FORMAT=WKT2_2019", nullptr};
  crs->exportToWkt(&text, options.data());
  std::string wkt = text == nullptr ? "" : text;
  CPLFree(text);
  return wkt;
}

}  // namespace

void fail_to_read(const std::filesystem::path& path, const std::string& words) {
  throw io::Error(
      {.file = path,
       .expected = "a GeoTIFF",
       .got = words.empty() ? "something else" : "'" + words + "'",
       .remedy = "gdalinfo shows what it is, gdal_translate makes one of other rasters"});
}

DatasetPtr open_raster(const std::filesystem::path& path) {
  std::error_code error;
  // GDAL would take some names for addresses and parts of files.
  if (!std::filesystem::is_regular_file(path, error))
    throw io::Error({.file = path, .expected = "a GeoTIFF", .got = "no file of that name"});
  const GdalErrors errors;
  (void)geotiff_driver();
  const std::array<const char*, 2> drivers{"GTiff", nullptr};
  const std::string name = std::filesystem::absolute(path).string();
  DatasetPtr raster(
      GDALDataset::Open(name.c_str(), GDAL_OF_RASTER | GDAL_OF_READONLY, drivers.data()));
  if (raster == nullptr || raster->GetRasterCount() == 0) fail_to_read(path, errors.first());
  std::array<double, 6> transform{};
  if (raster->GetGeoTransform(transform.data()) != CE_None)
    throw io::Error({.file = path,
                     .expected = "a raster that says where it lies",
                     .got = "one without georeference",
                     .remedy = "set it with gdal_edit.py -a_ullr WEST NORTH EAST SOUTH"});
  return raster;
}

RasterFrame frame_of(GDALDataset& raster) {
  RasterFrame frame{.columns = raster.GetRasterXSize(),
                    .rows = raster.GetRasterYSize(),
                    .transform = {},
                    .crs = wkt_of(raster.GetSpatialRef())};
  raster.GetGeoTransform(frame.transform.data());
  return frame;
}

LinearValues linear_values(GDALRasterBand& band) {
  LinearValues values;
  int has_scale = 0;
  int has_offset = 0;
  const double scale = band.GetScale(&has_scale);
  const double offset = band.GetOffset(&has_offset);
  if (has_scale != 0) values.scale = scale;
  if (has_offset != 0) values.offset = offset;
  return values;
}

}  // namespace groundgrid::geotiff
