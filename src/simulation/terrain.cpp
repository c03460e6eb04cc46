#include "simulation/terrain.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace groundgrid::simulation {
namespace {

constexpr double kTile_m = 12.8;

/// Squares along the side of a tile, by how far it is from the path and what is driven of it.
int cells_for(const Station& station, double driven_m) {
  const double beside = std::abs(station.d);
  const double beyond = std::max(-station.s, station.s - driven_m);
  if (beside < 14.0 && beyond < 30.0) return 128;
  if (beside < 22.0 && beyond < 30.0) return 64;
  if (beside < 22.0) return 32;
  if (beside < 45.0) return 16;
  return 4;
}

}  // namespace

Terrain::Terrain(const Path& path, double driven_m, const GroundFunction& ground,
                 TileRunner& runner) {
  least_ = kTile_m * (path.least() / kTile_m).array().floor();
  const Eigen::Vector2d size = (path.greatest() - least_) / kTile_m;
  columns_ = static_cast<std::size_t>(std::ceil(size.x()));
  rows_ = static_cast<std::size_t>(std::ceil(size.y()));
  tiles_.resize(columns_ * rows_);
  runner.parallel_for_tiles(tiles_.size(), [&](std::size_t index) {
    Tile& tile = tiles_[index];
    const Eigen::Vector2d low = corner(index);
    tile.cells = cells_for(path.project(low.array() + kTile_m / 2.0), driven_m);
    const double step = kTile_m / tile.cells;
    tile.heights.reserve(static_cast<std::size_t>((tile.cells + 1) * (tile.cells + 1)));
    for (int row = 0; row <= tile.cells; ++row)
      for (int column = 0; column <= tile.cells; ++column)
        tile.heights.push_back(
            static_cast<float>(ground(low + step * Eigen::Vector2d(column, row)).height_m));
  });
  close_cracks();
  mesh_.add_surface({.label = 72, .reflectivity = 0.3F});
  for (std::size_t i = 0; i < tiles_.size(); ++i) add_to_mesh(tiles_[i], corner(i));
}

Eigen::Vector2d Terrain::corner(std::size_t tile) const {
  const std::size_t row = tile / columns_;
  return least_ +
         kTile_m * Eigen::Vector2d(static_cast<double>(tile % columns_), static_cast<double>(row));
}

// Sides: 0 south, 1 north, 2 west, 3 east of the tile.
void Terrain::fit_to_neighbour(Tile& tile, const Tile& neighbour, int side) {
  if (neighbour.cells >= tile.cells) return;
  const int ratio = tile.cells / neighbour.cells;
  const int edge = side % 2 == 0 ? 0 : tile.cells;
  const auto at = [&](int along) {
    return side < 2 ? tile.index(along, edge) : tile.index(edge, along);
  };
  for (int along = 0; along < tile.cells; ++along) {
    const int low = along / ratio * ratio;
    const float share = static_cast<float>(along - low) / static_cast<float>(ratio);
    tile.heights[at(along)] =
        (1.0F - share) * tile.heights[at(low)] + share * tile.heights[at(low + ratio)];
  }
}

void Terrain::close_cracks() {
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    const std::size_t column = i % columns_;
    const std::size_t row = i / columns_;
    if (row > 0) fit_to_neighbour(tiles_[i], tiles_[i - columns_], 0);
    if (row + 1 < rows_) fit_to_neighbour(tiles_[i], tiles_[i + columns_], 1);
    if (column > 0) fit_to_neighbour(tiles_[i], tiles_[i - 1], 2);
    if (column + 1 < columns_) fit_to_neighbour(tiles_[i], tiles_[i + 1], 3);
  }
}

void Terrain::add_to_mesh(const Tile& tile, const Eigen::Vector2d& corner) {
  const double step = kTile_m / tile.cells;
  const auto first = static_cast<std::uint32_t>(mesh_.vertices.size());
  for (int row = 0; row <= tile.cells; ++row)
    for (int column = 0; column <= tile.cells; ++column)
      mesh_.add_vertex({corner.x() + step * column, corner.y() + step * row,
                        static_cast<double>(tile.heights[tile.index(column, row)])});
  const auto vertex = [&](int column, int row) {
    return first + static_cast<std::uint32_t>(tile.index(column, row));
  };
  for (int row = 0; row < tile.cells; ++row)
    for (int column = 0; column < tile.cells; ++column) {
      mesh_.add_triangle(vertex(column, row), vertex(column + 1, row), vertex(column + 1, row + 1),
                         0);
      mesh_.add_triangle(vertex(column, row), vertex(column + 1, row + 1), vertex(column, row + 1),
                         0);
    }
}

double Terrain::height(const Eigen::Vector2d& place) const {
  const Eigen::Vector2d last(static_cast<double>(columns_) - 1e-9,
                             static_cast<double>(rows_) - 1e-9);
  const Eigen::Vector2d in_tiles =
      ((place - least_) / kTile_m).cwiseMax(Eigen::Vector2d::Zero()).cwiseMin(last);
  const Eigen::Vector2d low = in_tiles.array().floor();
  const Tile& tile =
      tiles_[static_cast<std::size_t>(low.y()) * columns_ + static_cast<std::size_t>(low.x())];
  const Eigen::Vector2d in_cells = (in_tiles - low) * tile.cells;
  const int column = std::min(static_cast<int>(in_cells.x()), tile.cells - 1);
  const int row = std::min(static_cast<int>(in_cells.y()), tile.cells - 1);
  const double u = in_cells.x() - column;
  const double v = in_cells.y() - row;
  const auto at = [&](int east, int north) {
    return static_cast<double>(tile.heights[tile.index(column + east, row + north)]);
  };
  // The diagonal of each square runs from south-west to north-east, as in the mesh.
  if (u >= v) return at(0, 0) + u * (at(1, 0) - at(0, 0)) + v * (at(1, 1) - at(1, 0));
  return at(0, 0) + v * (at(0, 1) - at(0, 0)) + u * (at(1, 1) - at(0, 1));
}

}  // namespace groundgrid::simulation
