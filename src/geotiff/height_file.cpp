#include "geotiff/height_file.hpp"

#include <cpl_string.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/geotiff_driver.hpp"
#include "geotiff/terrain_raster.hpp"
#include "io/hidden_file.hpp"

namespace groundgrid::geotiff {
namespace {

void check(const std::filesystem::path& path, const GdalErrors& errors, bool succeeded) {
  if (succeeded && errors.first().empty()) return;
  io::fail_to_write(path, errors.first().empty() ? "an error without a word" : errors.first());
}

DatasetPtr create(const std::filesystem::path& path, const RasterGrid& grid) {
  CPLStringList options;
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  return DatasetPtr(geotiff_driver().Create(path.c_str(), static_cast<int>(grid.columns),
                                            static_cast<int>(grid.rows), 1, GDT_Float32,
                                            options.List()));
}

bool write_rows(GDALRasterBand& band, const RasterGrid& grid, std::span<const float> heights) {
  const auto columns = static_cast<std::size_t>(grid.columns);
  const int width = static_cast<int>(grid.columns);
  for (int row = 0; row < static_cast<int>(grid.rows); ++row) {
    const std::span<const float> north = heights.last(columns);
    heights = heights.first(heights.size() - columns);
    std::vector<float> line(north.begin(), north.end());
    if (band.RasterIO(GF_Write, 0, row, width, 1, line.data(), width, 1, GDT_Float32, 0, 0,
                      nullptr) != CE_None)
      return false;
  }
  return true;
}

}  // namespace

void write_heights(const std::filesystem::path& path, const RasterGrid& grid,
                   std::span<const float> heights) {
  if (static_cast<std::int64_t>(heights.size()) != grid.columns * grid.rows)
    throw std::invalid_argument("a height raster needs a height for each of its cells, not " +
                                std::to_string(heights.size()));
  const GdalErrors errors;
  io::HiddenFile file(path);
  DatasetPtr dataset = create(file.hidden(), grid);
  check(path, errors, dataset != nullptr);
  std::array<double, 6> transform{
      grid.min_x_m, grid.resolution_m,
      0.0,          grid.min_y_m + static_cast<double>(grid.rows) * grid.resolution_m,
      0.0,          -grid.resolution_m};
  check(path, errors, dataset->SetGeoTransform(transform.data()) == CE_None);
  GDALRasterBand& band = *dataset->GetRasterBand(1);
  band.SetDescription("height");
  check(path, errors, band.SetUnitType("m") == CE_None);
  check(path, errors, band.SetNoDataValue(static_cast<double>(kNoData)) == CE_None);
  check(path, errors, write_rows(band, grid, heights));
  dataset.reset();
  check(path, errors, true);
  file.commit();
}

}  // namespace groundgrid::geotiff
