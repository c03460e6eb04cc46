#pragma once

#include <ogr_spatialref.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>

#include "geotiff/cell_range.hpp"
#include "geotiff/gdal_errors.hpp"
#include "geotiff/geotiff_driver.hpp"
#include "geotiff/raster_grid.hpp"
#include "geotiff/terrain_block.hpp"
#include "io/hidden_file.hpp"

namespace groundgrid::geotiff {

/// What a band of a raster holds.
struct RasterBand {
  const char* name;
  const char* unit;
};

/// The bands that kTerrainBands tells of.
std::span<const RasterBand> terrain_bands();

/// A terrain GeoTIFF that is written block by block and appears complete or not at all. Blocks
/// that are never written take no room and read as no-data.
///
/// GDAL's cache of blocks is passed by, so memory stays at one block whatever the raster's size.
/// Every call throws io::Error, with GDAL's words, where the file cannot be written. All calls
/// must come from one thread.
class TerrainFile {
 public:
  /// Throws io::Error also where the raster has more blocks than one file should.
  TerrainFile(const std::filesystem::path& path, const RasterGrid& grid,
              const std::optional<OGRSpatialReference>& crs,
              std::span<const RasterBand> bands = terrain_bands());

  [[nodiscard]] int block_columns() const;
  [[nodiscard]] int block_rows() const;

  /// The cells under a block, counted from the raster's south-western corner; in the last block
  /// of a row or column some lie outside the raster.
  [[nodiscard]] CellRange cells_of(int block_column, int block_row) const;

  void write(int block_column, int block_row, TerrainBlock& block);
  /// TerrainBlock::kSide² pixels of one band, counted from 0, as GDAL wants them.
  void write(int block_column, int block_row, int band, float* pixels);

  /// Closes the file and gives it its name.
  void commit();

 private:
  void describe(const RasterGrid& grid, const std::optional<OGRSpatialReference>& crs,
                std::span<const RasterBand> bands);
  void check(bool succeeded) const;

  // In the order of their making: what GDAL says while it closes must still find a listener.
  GdalErrors errors_;
  io::HiddenFile file_;
  RasterGrid grid_;
  DatasetPtr dataset_;
};

/// An io::Error for a file to be that would hold no cell.
[[noreturn]] void fail_without_terrain(const std::filesystem::path& path);

}  // namespace groundgrid::geotiff
