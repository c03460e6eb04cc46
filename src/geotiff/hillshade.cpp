#include "geotiff/hillshade.hpp"

#include <cpl_string.h>
#include <fmt/format.h>
#include <gdal_frmts.h>
#include <gdal_utils.h>

#include <array>
#include <limits>
#include <memory>
#include <new>
#include <stdexcept>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/geotiff_driver.hpp"

namespace groundgrid::geotiff {
namespace {

struct FreeOptions {
  void operator()(GDALDEMProcessingOptions* options) const {
    GDALDEMProcessingOptionsFree(options);
  }
};
using OptionsPtr = std::unique_ptr<GDALDEMProcessingOptions, FreeOptions>;

[[noreturn]] void fail(const GdalErrors& errors) {
  throw std::runtime_error("the terrain cannot be shaded: " + errors.first());
}

DatasetPtr raster_of(const ShadedCells& cells, const GdalErrors& errors) {
  GDALRegister_MEM();
  GDALDriver* const memory = GetGDALDriverManager()->GetDriverByName("MEM");
  DatasetPtr raster(memory->Create("", cells.columns, cells.rows, 1, GDT_Float32, nullptr));
  if (raster == nullptr) throw std::bad_alloc();
  std::array<double, 6> transform{0.0, cells.cell_width_m, 0.0, 0.0, 0.0, -cells.cell_height_m};
  raster->SetGeoTransform(transform.data());
  GDALRasterBand& band = *raster->GetRasterBand(1);
  band.SetNoDataValue(std::numeric_limits<double>::quiet_NaN());
  std::vector<float> heights(cells.heights_m.begin(), cells.heights_m.end());
  if (band.RasterIO(GF_Write, 0, 0, cells.columns, cells.rows, heights.data(), cells.columns,
                    cells.rows, GDT_Float32, 0, 0, nullptr) != CE_None)
    fail(errors);
  return raster;
}

OptionsPtr shading_options(double exaggeration) {
  CPLStringList words;
  for (const char* word : {"-of", "MEM", "-compute_edges", "-z"}) words.AddString(word);
  words.AddString(fmt::format("{}", exaggeration).c_str());
  return OptionsPtr(GDALDEMProcessingOptionsNew(words.List(), nullptr));
}

}  // namespace

std::vector<std::uint8_t> hillshade(const ShadedCells& cells, double exaggeration) {
  std::vector<std::uint8_t> shade(static_cast<std::size_t>(cells.columns) *
                                  static_cast<std::size_t>(cells.rows));
  if (cells.heights_m.size() != shade.size())
    throw std::invalid_argument("shading needs a height for each cell");
  const GdalErrors errors;
  const DatasetPtr raster = raster_of(cells, errors);
  const OptionsPtr options = shading_options(exaggeration);
  const DatasetPtr shaded(GDALDataset::FromHandle(GDALDEMProcessing(
      "", GDALDataset::ToHandle(raster.get()), "hillshade", nullptr, options.get(), nullptr)));
  if (shaded == nullptr) fail(errors);
  if (shaded->GetRasterBand(1)->RasterIO(GF_Read, 0, 0, cells.columns, cells.rows, shade.data(),
                                         cells.columns, cells.rows, GDT_Byte, 0, 0,
                                         nullptr) != CE_None)
    fail(errors);
  return shade;
}

}  // namespace groundgrid::geotiff
