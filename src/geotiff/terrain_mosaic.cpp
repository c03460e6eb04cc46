#include "geotiff/terrain_mosaic.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "geotiff/cell_range.hpp"
#include "geotiff/crs.hpp"
#include "geotiff/drive_lattice.hpp"
#include "geotiff/point_density.hpp"
#include "geotiff/terrain_file.hpp"
#include "geotiff/terrain_surface.hpp"
#include "geotiff/tile_store.hpp"
#include "geotiff/view_check.hpp"

namespace groundgrid::geotiff {
namespace {

// Tiles this near to the window stay in memory: a vehicle that goes to and fro at a tile's edge
// shall not send the same tiles away and back.
constexpr std::int64_t kMargin = MosaicTile::kSide / 2;

std::size_t cell_in_view(const TerrainView& view, std::int64_t column, std::int64_t row) {
  return static_cast<std::size_t>(row * view.size + column);
}

bool is_known(float confidence) { return confidence > 0.0F; }

/// The cells of a view that have a height or points around them, counted from its corner.
CellRange told_cells(const TerrainView& view, const std::vector<std::uint32_t>& points_around) {
  CellRange all;
  for (int row = 0; row < view.size; ++row) {
    const auto told = [&](std::int64_t column) {
      const std::size_t cell = cell_in_view(view, column, row);
      return is_known(view.confidence[cell]) || points_around[cell] > 0;
    };
    std::int64_t first = 0;
    while (first < view.size && !told(first)) ++first;
    if (first == view.size) continue;
    std::int64_t end = view.size;
    while (!told(end - 1)) --end;
    all = hull(all, {first, end, row, row + 1});
  }
  return all;
}

float height_of(const MosaicTile& tile, std::size_t cell) {
  return static_cast<float>(tile.weighted_height[cell] / tile.weight[cell]);
}

TerrainPixel pixel_of(const MosaicTile& tile, std::size_t cell, double area_m2) {
  const bool known = tile.weight[cell] > 0.0;
  TerrainPixel pixel;
  if (known) {
    pixel.height = height_of(tile, cell);
    pixel.confidence = tile.confidence[cell];
  }
  if (known || tile.most_points_around[cell] > 0) {
    pixel.count = static_cast<float>(tile.points[cell]);
    pixel.density =
        static_cast<float>(static_cast<double>(tile.most_points_around[cell]) / area_m2);
  }
  return pixel;
}

void copy(const MosaicTile& tile, const CellRange& tile_cells, double area_m2,
          TerrainBlock& block) {
  const CellRange cells = overlap(tile_cells, block.cells());
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column) {
      const std::size_t cell = index_in(tile_cells, column, row);
      block.set(column, row, pixel_of(tile, cell, area_m2));
    }
  }
}

void copy_heights(const MosaicTile& tile, const CellRange& tile_cells, HeightWindow& window) {
  const CellRange cells = overlap(tile_cells, window.cells);
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column) {
      const std::size_t cell = index_in(tile_cells, column, row);
      if (tile.weight[cell] > 0.0)
        window.heights[window.index(column, row)] = height_of(tile, cell);
    }
  }
}

}  // namespace

class TerrainMosaic::Tiles {
 public:
  Tiles(std::filesystem::path path, const std::string& crs,
        const std::optional<SurfaceOptions>& surface)
      : path_(std::move(path)), crs_(read_crs(crs)), surface_(surface), store_(path_) {}

  void add(const TerrainView& view);
  void finish() const;
  [[nodiscard]] bool empty() const { return !has_height_; }
  [[nodiscard]] std::size_t resident_bytes() const { return store_.resident_bytes(); }

 private:
  void add_to_tile(TileStore::Index index, const TerrainView& view, const CellRange& window);
  bool fill(TerrainBlock& block, MosaicTile& buffer) const;
  [[nodiscard]] HeightWindow heights_in(const CellRange& cells, MosaicTile& buffer) const;

  std::filesystem::path path_;
  std::optional<OGRSpatialReference> crs_;
  std::optional<SurfaceOptions> surface_;
  TileStore store_;
  DriveLattice lattice_;
  CellRange told_;
  bool has_height_ = false;
  std::vector<std::uint32_t> points_around_;  // of the view that is being added
};

void TerrainMosaic::Tiles::add(const TerrainView& view) {
  check_view(view);
  if (view.size == 0) return;
  const CellRange window = lattice_.window_of(view);
  store_.keep_only({window.first_column - kMargin, window.end_column + kMargin,
                    window.first_row - kMargin, window.end_row + kMargin});
  count_points_around(view, points_around_);
  const CellRange tiles = tiles_of(window);
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i)
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j)
      add_to_tile({i, j}, view, window);
  const CellRange told = told_cells(view, points_around_);
  if (!told.empty()) told_ = hull(told_, moved(told, window.first_column, window.first_row));
  has_height_ =
      has_height_ || std::any_of(view.confidence.begin(), view.confidence.end(), is_known);
}

void TerrainMosaic::Tiles::add_to_tile(TileStore::Index index, const TerrainView& view,
                                       const CellRange& window) {
  MosaicTile& tile = store_.load(index);
  const CellRange tile_cells = cells_of(index);
  const CellRange cells = overlap(tile_cells, window);
  const auto count = static_cast<std::size_t>(cells.columns());
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    const std::size_t first =
        cell_in_view(view, cells.first_column - window.first_column, row - window.first_row);
    tile.add(
        static_cast<std::size_t>(cells.first_column - tile_cells.first_column),
        static_cast<std::size_t>(row - tile_cells.first_row),
        {view.relative_height.subspan(first, count), view.confidence.subspan(first, count),
         view.statistics.subspan(first, count),
         std::span<const std::uint32_t>(points_around_).subspan(first, count), view.z_origin_m});
  }
}

bool TerrainMosaic::Tiles::fill(TerrainBlock& block, MosaicTile& buffer) const {
  const CellRange tiles = tiles_of(block.cells());
  bool filled = false;
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i) {
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j) {
      const MosaicTile* const tile = store_.look_up({i, j}, buffer);
      if (tile == nullptr) continue;
      copy(*tile, cells_of({i, j}), density_area_m2(lattice_.cell_size_m()), block);
      filled = true;
    }
  }
  return filled;
}

HeightWindow TerrainMosaic::Tiles::heights_in(const CellRange& cells, MosaicTile& buffer) const {
  HeightWindow window(cells);
  const CellRange tiles = tiles_of(cells);
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i) {
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j) {
      const MosaicTile* const tile = store_.look_up({i, j}, buffer);
      if (tile != nullptr) copy_heights(*tile, cells_of({i, j}), window);
    }
  }
  return window;
}

void TerrainMosaic::Tiles::finish() const {
  if (empty()) fail_without_terrain(path_);
  TerrainFile file(path_, lattice_.grid_of(told_), crs_);
  const auto buffer = std::make_unique<MosaicTile>();
  TerrainSurface completion(surface_, lattice_.cell_size_m());
  TerrainBlock block;
  for (int row = 0; row < file.block_rows(); ++row) {
    for (int column = 0; column < file.block_columns(); ++column) {
      block.move_to(moved(file.cells_of(column, row), told_.first_column, told_.first_row));
      const bool told = fill(block, *buffer);
      HeightWindow window = heights_in(completion.window_around(block.cells()), *buffer);
      completion.complete(window);
      if (block.take_heights(window) || told) file.write(column, row, block);
    }
  }
  file.commit();
}

TerrainMosaic::TerrainMosaic(std::filesystem::path path, const std::string& crs,
                             const std::optional<SurfaceOptions>& surface)
    : tiles_(std::make_unique<Tiles>(std::move(path), crs, surface)) {}
TerrainMosaic::~TerrainMosaic() = default;
TerrainMosaic::TerrainMosaic(TerrainMosaic&&) noexcept = default;
TerrainMosaic& TerrainMosaic::operator=(TerrainMosaic&&) noexcept = default;

void TerrainMosaic::add(const TerrainView& terrain) { tiles_->add(terrain); }
void TerrainMosaic::finish() { tiles_->finish(); }
bool TerrainMosaic::empty() const { return tiles_->empty(); }
std::size_t TerrainMosaic::resident_bytes() const { return tiles_->resident_bytes(); }

}  // namespace groundgrid::geotiff
