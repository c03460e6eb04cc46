#include "geotiff/terrain_file.hpp"

#include <cpl_string.h>
#include <fmt/format.h>

#include <array>
#include <string>

#include "io/error.hpp"

namespace groundgrid::geotiff {
namespace {

// The offsets of so many blocks alone take 48 MB. At 0.33 m cells it is a square of 84 km.
constexpr std::int64_t kMostBlocks = 1'000'000;

constexpr std::array<RasterBand, kTerrainBands> kBands{{{"height", "m"},
                                                        {"confidence", ""},
                                                        {"count", ""},
                                                        {"density", "1/m2"},
                                                        {"standard deviation", "m"}}};

void check_size(const std::filesystem::path& path, const RasterGrid& grid) {
  if (blocks_over(grid.columns) <= kMostBlocks / blocks_over(grid.rows)) return;
  throw io::Error(
      {.file = path,
       .expected = "a drive that one raster can hold",
       .got = fmt::format("one over {:.0f} km by {:.0f} km",
                          static_cast<double>(grid.columns) * grid.resolution_m / 1000.0,
                          static_cast<double>(grid.rows) * grid.resolution_m / 1000.0),
       .remedy = "check the poses for one that is far off"});
}

GDALDataset* create_raster(const std::filesystem::path& path, const RasterGrid& grid,
                           std::size_t bands) {
  const std::string side = std::to_string(TerrainBlock::kSide);
  CPLStringList options;
  options.SetNameValue("TILED", "YES");
  options.SetNameValue("BLOCKXSIZE", side.c_str());
  options.SetNameValue("BLOCKYSIZE", side.c_str());
  options.SetNameValue("INTERLEAVE", "BAND");
  options.SetNameValue("COMPRESS", "DEFLATE");
  options.SetNameValue("PREDICTOR", "3");
  options.SetNameValue("BIGTIFF", "IF_SAFER");
  options.SetNameValue("SPARSE_OK", "TRUE");
  return geotiff_driver().Create(path.c_str(), static_cast<int>(grid.columns),
                                 static_cast<int>(grid.rows), static_cast<int>(bands), GDT_Float32,
                                 options.List());
}

}  // namespace

std::span<const RasterBand> terrain_bands() { return kBands; }

TerrainFile::TerrainFile(const std::filesystem::path& path, const RasterGrid& grid,
                         const std::optional<OGRSpatialReference>& crs,
                         std::span<const RasterBand> bands)
    : file_(path), grid_(grid) {
  check_size(path, grid);
  dataset_.reset(create_raster(file_.hidden(), grid, bands.size()));
  check(dataset_ != nullptr);
  describe(grid, crs, bands);
}

void TerrainFile::describe(const RasterGrid& grid, const std::optional<OGRSpatialReference>& crs,
                           std::span<const RasterBand> bands) {
  const double max_y = grid.min_y_m + static_cast<double>(grid.rows) * grid.resolution_m;
  std::array<double, 6> transform{grid.min_x_m, grid.resolution_m, 0.0, max_y,
                                  0.0,          -grid.resolution_m};
  check(dataset_->SetGeoTransform(transform.data()) == CE_None);
  if (crs) check(dataset_->SetSpatialRef(&*crs) == CE_None);
  int index = 0;
  for (const RasterBand& what : bands) {
    GDALRasterBand& band = *dataset_->GetRasterBand(++index);
    band.SetDescription(what.name);
    check(band.SetUnitType(what.unit) == CE_None);
    check(band.SetNoDataValue(static_cast<double>(kNoData)) == CE_None);
  }
}

int TerrainFile::block_columns() const { return static_cast<int>(blocks_over(grid_.columns)); }
int TerrainFile::block_rows() const { return static_cast<int>(blocks_over(grid_.rows)); }

CellRange TerrainFile::cells_of(int block_column, int block_row) const {
  return cells_of_block(grid_, block_column, block_row);
}

void TerrainFile::write(int block_column, int block_row, TerrainBlock& block) {
  for (int index = 0; index < kTerrainBands; ++index)
    write(block_column, block_row, index, block.band(index));
}

void TerrainFile::write(int block_column, int block_row, int band, float* pixels) {
  GDALRasterBand& raster = *dataset_->GetRasterBand(band + 1);
  check(raster.WriteBlock(block_column, block_row, pixels) == CE_None);
}

void TerrainFile::commit() {
  // Closing writes the index of the blocks; only the listener hears where that fails.
  dataset_.reset();
  check(true);
  file_.commit();
}

void TerrainFile::check(bool succeeded) const {
  if (succeeded && errors_.first().empty()) return;
  io::fail_to_write(file_.path(),
                    errors_.first().empty() ? "an error without a word" : errors_.first());
}

void fail_without_terrain(const std::filesystem::path& path) {
  throw io::Error({.file = path,
                   .expected = "terrain to write",
                   .got = "a map in which no scan has shown any ground"});
}

}  // namespace groundgrid::geotiff
