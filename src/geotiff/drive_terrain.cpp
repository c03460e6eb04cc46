#include "geotiff/drive_terrain.hpp"

#include <algorithm>
#include <span>
#include <utility>

#include "geotiff/point_density.hpp"
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

DriveTerrain::DriveTerrain(const std::filesystem::path& result,
                           const std::optional<SurfaceOptions>& surface)
    : surface_(surface), store_(result) {}

void DriveTerrain::add(const TerrainView& view) {
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

void DriveTerrain::add_to_tile(TileStore::Index index, const TerrainView& view,
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
         statistics_of(view).subspan(first, count),
         std::span<const std::uint32_t>(points_around_).subspan(first, count), view.z_origin_m});
  }
}

bool DriveTerrain::fill(TerrainBlock& block, MosaicTile& buffer) const {
  const CellRange tiles = tiles_of(block.cells());
  bool filled = false;
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i) {
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j) {
      const MosaicTile* const tile = store_.look_up({i, j}, buffer);
      if (tile == nullptr) continue;
      copy(*tile, cells_of({i, j}), density_area_m2(lattice_.resolution_m()), block);
      filled = true;
    }
  }
  return filled;
}

HeightWindow DriveTerrain::heights_in(const CellRange& cells, MosaicTile& buffer) const {
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

DriveTerrain::Blocks::Blocks(const DriveTerrain& terrain)
    : terrain_(terrain),
      buffer_(std::make_unique<MosaicTile>()),
      completion_(terrain.surface_, terrain.lattice_.resolution_m()) {}

TerrainBlock* DriveTerrain::Blocks::read(const CellRange& cells) {
  block_.move_to(moved(cells, terrain_.told_.first_column, terrain_.told_.first_row));
  const bool told = terrain_.fill(block_, *buffer_);
  HeightWindow window = terrain_.heights_in(completion_.window_around(block_.cells()), *buffer_);
  completion_.complete(window);
  return block_.take_heights(window) || told ? &block_ : nullptr;
}

}  // namespace groundgrid::geotiff
