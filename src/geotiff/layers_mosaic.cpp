#include "geotiff/layers_mosaic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>
#include <vector>

#include "geotiff/crs.hpp"
#include "geotiff/drive_lattice.hpp"
#include "geotiff/terrain_file.hpp"
#include "geotiff/tile_store.hpp"
#include "geotiff/view_check.hpp"

namespace groundgrid::geotiff {
namespace {

constexpr std::int64_t kLayersMargin = LayersTile::kSide / 2;
constexpr float kUnknown = std::numeric_limits<float>::quiet_NaN();
constexpr std::array<RasterBand, kLayerBands> kLayers{{{"slope", "deg"},
                                                       {"step", "m"},
                                                       {"roughness", "m"},
                                                       {"obstacle_height", "m"},
                                                       {"traversability", ""}}};

using LayerPixel = std::array<float, kLayerBands>;

float number_of(Traversability traversability) {
  if (traversability == Traversability::unknown) return kUnknown;
  return traversability == Traversability::yes ? 1.0F : 0.0F;
}

/// Takes over what a scan told about a cell. False where that is nothing.
bool tell(LayersTile& tile, std::size_t in_tile, const TerrainView& view,
          const TerrainLayers& layers, std::size_t in_view) {
  const float obstacle = layers.obstacle_height_m()[in_view];
  const float slope = layers.slope_deg()[in_view];
  const float step = layers.step_m()[in_view];
  const float confidence = view.confidence[in_view];
  const bool ground = !std::isnan(slope) || !std::isnan(step);
  if (!std::isnan(obstacle)) tile.obstacle_height_m[in_tile] = obstacle;
  if (ground && confidence >= tile.confidence[in_tile]) {
    tile.confidence[in_tile] = confidence;
    tile.slope_deg[in_tile] = slope;
    tile.step_m[in_tile] = step;
    tile.roughness_m[in_tile] = layers.roughness_m()[in_view];
  }
  return ground || !std::isnan(obstacle);
}

LayerPixel layer_pixel(const LayersTile& tile, std::size_t cell,
                       const TraversabilityLimits& limits) {
  CellLayers layers{tile.slope_deg[cell], tile.step_m[cell], tile.roughness_m[cell],
                    tile.obstacle_height_m[cell]};
  LayerPixel pixel{layers.slope_deg, layers.step_m, layers.roughness_m, layers.obstacle_height_m};
  // 0 is no obstacle even where no obstacle is too low.
  if (layers.obstacle_height_m == 0.0F) layers.obstacle_height_m = kUnknown;
  pixel.back() = number_of(traversability_of(layers, limits));
  for (float& value : pixel)
    if (std::isnan(value)) value = kNoData;
  return pixel;
}

/// The pixels of one block, band after band, row 0 in the north as GeoTIFF wants it.
class LayersBlock {
 public:
  LayersBlock() : pixels_(kLayerBands * kPixels) {}

  void move_to(const CellRange& cells) {
    cells_ = cells;
    std::fill(pixels_.begin(), pixels_.end(), kNoData);
  }

  [[nodiscard]] const CellRange& cells() const { return cells_; }

  void set(std::int64_t column, std::int64_t row, const LayerPixel& values) {
    auto pixel = static_cast<std::size_t>((cells_.end_row - 1 - row) * TerrainBlock::kSide +
                                          column - cells_.first_column);
    for (const float value : values) {
      pixels_[pixel] = value;
      pixel += kPixels;
    }
  }

  float* band(int index) { return pixels_.data() + static_cast<std::size_t>(index) * kPixels; }

 private:
  static constexpr std::size_t kPixels = std::size_t{TerrainBlock::kSide} * TerrainBlock::kSide;

  CellRange cells_;
  std::vector<float> pixels_;
};

void copy_layers(const LayersTile& tile, const CellRange& tile_cells,
                 const TraversabilityLimits& limits, LayersBlock& block) {
  const CellRange cells = overlap(tile_cells, block.cells());
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row)
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column)
      block.set(column, row, layer_pixel(tile, index_in(tile_cells, column, row), limits));
}

}  // namespace

class LayersMosaic::Tiles {
 public:
  Tiles(std::filesystem::path path, const TraversabilityLimits& limits, const std::string& crs)
      : path_(std::move(path)), limits_(limits), crs_(read_crs(crs)), store_(path_) {
    limits_.validate();
  }

  void add(const TerrainView& view, const TerrainLayers& layers);
  void finish() const;
  [[nodiscard]] bool empty() const { return told_.empty(); }

 private:
  void add_to_tile(TileIndex index, const TerrainView& view, const TerrainLayers& layers,
                   const CellRange& window);
  bool fill(LayersBlock& block, LayersTile& buffer) const;

  std::filesystem::path path_;
  TraversabilityLimits limits_;
  std::optional<OGRSpatialReference> crs_;
  LayersTileStore store_;
  DriveLattice lattice_;
  CellRange told_;
};

void LayersMosaic::Tiles::add(const TerrainView& view, const TerrainLayers& layers) {
  check_view(view);
  if (layers.size() != view.size)
    throw std::invalid_argument("LayersMosaic: the layers are not those of the view");
  if (view.size == 0) return;
  const CellRange window = lattice_.window_of(view);
  store_.keep_only({window.first_column - kLayersMargin, window.end_column + kLayersMargin,
                    window.first_row - kLayersMargin, window.end_row + kLayersMargin});
  const CellRange tiles = tiles_of(window);
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i)
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j)
      add_to_tile({i, j}, view, layers, window);
}

void LayersMosaic::Tiles::add_to_tile(TileIndex index, const TerrainView& view,
                                      const TerrainLayers& layers, const CellRange& window) {
  LayersTile& tile = store_.load(index);
  const CellRange tile_cells = cells_of(index);
  const CellRange cells = overlap(tile_cells, window);
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column) {
      const auto in_view = static_cast<std::size_t>((row - window.first_row) * view.size + column -
                                                    window.first_column);
      if (tell(tile, index_in(tile_cells, column, row), view, layers, in_view))
        told_ = hull(told_, {column, column + 1, row, row + 1});
    }
  }
}

bool LayersMosaic::Tiles::fill(LayersBlock& block, LayersTile& buffer) const {
  const CellRange tiles = tiles_of(block.cells());
  bool filled = false;
  for (std::int64_t i = tiles.first_column; i < tiles.end_column; ++i) {
    for (std::int64_t j = tiles.first_row; j < tiles.end_row; ++j) {
      const LayersTile* const tile = store_.look_up({i, j}, buffer);
      if (tile == nullptr) continue;
      copy_layers(*tile, cells_of({i, j}), limits_, block);
      filled = true;
    }
  }
  return filled;
}

void LayersMosaic::Tiles::finish() const {
  if (empty()) fail_without_terrain(path_);
  TerrainFile file(path_, lattice_.grid_of(told_), crs_, kLayers);
  const auto buffer = std::make_unique<LayersTile>();
  LayersBlock block;
  for (int row = 0; row < file.block_rows(); ++row) {
    for (int column = 0; column < file.block_columns(); ++column) {
      block.move_to(moved(file.cells_of(column, row), told_.first_column, told_.first_row));
      if (!fill(block, *buffer)) continue;
      for (int band = 0; band < kLayerBands; ++band)
        file.write(column, row, band, block.band(band));
    }
  }
  file.commit();
}

LayersMosaic::LayersMosaic(std::filesystem::path path, const TraversabilityLimits& limits,
                           const std::string& crs)
    : tiles_(std::make_unique<Tiles>(std::move(path), limits, crs)) {}
LayersMosaic::~LayersMosaic() = default;
LayersMosaic::LayersMosaic(LayersMosaic&&) noexcept = default;
LayersMosaic& LayersMosaic::operator=(LayersMosaic&&) noexcept = default;

void LayersMosaic::add(const TerrainView& terrain, const TerrainLayers& layers) {
  tiles_->add(terrain, layers);
}
void LayersMosaic::finish() { tiles_->finish(); }
bool LayersMosaic::empty() const { return tiles_->empty(); }

}  // namespace groundgrid::geotiff
