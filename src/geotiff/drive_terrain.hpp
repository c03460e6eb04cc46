#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "geotiff/cell_range.hpp"
#include "geotiff/drive_lattice.hpp"
#include "geotiff/mosaic_tile.hpp"
#include "geotiff/raster_grid.hpp"
#include "geotiff/surface_options.hpp"
#include "geotiff/terrain_block.hpp"
#include "geotiff/terrain_surface.hpp"
#include "geotiff/tile_store.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// The terrain of a whole drive, made scan by scan, as the blocks of a raster to be: what
/// TerrainMosaic writes, without GDAL. TerrainMosaic says where its memory lies and what counts.
class DriveTerrain {
 public:
  /// `result` is the file to be: its folder holds what is not in memory. Throws io::Error where
  /// that is not writable.
  DriveTerrain(const std::filesystem::path& result, const std::optional<SurfaceOptions>& surface);

  /// Adds the map as it stands after a scan; as TerrainMosaic::add().
  void add(const TerrainView& view);

  /// Whether no cell of any scan added had a confidence above 0.
  [[nodiscard]] bool empty() const { return !has_height_; }

  /// Bytes of the tiles that are in memory now.
  [[nodiscard]] std::size_t resident_bytes() const { return store_.resident_bytes(); }

  /// Where the raster of all cells that have a height or a density lies.
  [[nodiscard]] RasterGrid grid() const { return lattice_.grid_of(told_); }

  /// Makes the raster's blocks, one at a time. The terrain must outlive it and not change.
  class Blocks {
   public:
    explicit Blocks(const DriveTerrain& terrain);

    /// The block over these cells of grid(), TerrainBlock::kSide² of them, until the next call;
    /// null where nothing is known of any. Throws io::Error where a tile cannot be read.
    TerrainBlock* read(const CellRange& cells);

   private:
    const DriveTerrain& terrain_;
    std::unique_ptr<MosaicTile> buffer_;
    TerrainSurface completion_;
    TerrainBlock block_;
  };

 private:
  void add_to_tile(TileStore::Index index, const TerrainView& view, const CellRange& window);
  bool fill(TerrainBlock& block, MosaicTile& buffer) const;
  [[nodiscard]] HeightWindow heights_in(const CellRange& cells, MosaicTile& buffer) const;

  std::optional<SurfaceOptions> surface_;
  TileStore store_;
  DriveLattice lattice_;
  CellRange told_;
  bool has_height_ = false;
  std::vector<std::uint32_t> points_around_;  // of the view that is being added
};

}  // namespace groundgrid::geotiff
