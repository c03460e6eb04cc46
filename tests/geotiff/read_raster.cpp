#include "read_raster.hpp"

#include <gdal_frmts.h>
#include <gdal_priv.h>
#include <ogr_spatialref.h>

#include <memory>
#include <stdexcept>

namespace groundgrid::test {
namespace {

std::string text_of(const char* text) { return text == nullptr ? "" : text; }

Raster::Band read_band(GDALRasterBand& band) {
  Raster::Band result;
  result.name = band.GetDescription();
  result.unit = band.GetUnitType();
  result.type = GDALGetDataTypeName(band.GetRasterDataType());
  int has_no_data = 0;
  result.no_data = band.GetNoDataValue(&has_no_data);
  result.has_no_data = has_no_data != 0;
  const int columns = band.GetXSize();
  const int rows = band.GetYSize();
  result.pixels.resize(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  if (band.RasterIO(GF_Read, 0, 0, columns, rows, result.pixels.data(), columns, rows, GDT_Float32,
                    0, 0, nullptr) != CE_None)
    throw std::runtime_error("a band cannot be read");
  return result;
}

}  // namespace

float Raster::at(int band, int column, int row) const {
  const auto pixel = static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                     static_cast<std::size_t>(column);
  return bands.at(static_cast<std::size_t>(band) - 1).pixels.at(pixel);
}

Raster read_raster(const std::filesystem::path& path) {
  GDALRegister_GTiff();
  const std::unique_ptr<GDALDataset> dataset(GDALDataset::Open(path.c_str(), GDAL_OF_RASTER));
  if (dataset == nullptr) throw std::runtime_error("no raster: " + path.string());
  Raster raster;
  raster.columns = dataset->GetRasterXSize();
  raster.rows = dataset->GetRasterYSize();
  dataset->GetGeoTransform(raster.transform.data());
  if (const OGRSpatialReference* const crs = dataset->GetSpatialRef())
    raster.epsg =
        text_of(crs->GetAuthorityName(nullptr)) + ":" + text_of(crs->GetAuthorityCode(nullptr));
  raster.area_or_point = text_of(dataset->GetMetadataItem("AREA_OR_POINT"));
  raster.compression = text_of(dataset->GetMetadataItem("COMPRESSION", "IMAGE_STRUCTURE"));
  dataset->GetRasterBand(1)->GetBlockSize(&raster.block[0], &raster.block[1]);
  for (int band = 1; band <= dataset->GetRasterCount(); ++band)
    raster.bands.push_back(read_band(*dataset->GetRasterBand(band)));
  return raster;
}

}  // namespace groundgrid::test
