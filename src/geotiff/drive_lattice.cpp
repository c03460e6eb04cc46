#include "geotiff/drive_lattice.hpp"

#include <cmath>
#include <cstdint>
#include <stdexcept>

namespace groundgrid::geotiff {
namespace {

// Cells that a lattice may be away from its origin: 2⁵³ are exact in double.
constexpr double kFarthestCell = 9007199254740992.0;

std::int64_t nearest_cell(double metres, double resolution_m) {
  const double cell = metres / resolution_m;
  if (!(std::abs(cell) < kFarthestCell))
    throw std::invalid_argument("TerrainMosaic: a view lies too far from the first one");
  return std::llround(cell);
}

}  // namespace

CellRange DriveLattice::window_of(const TerrainView& view) {
  if (resolution_m_ == 0.0) {
    resolution_m_ = view.resolution_m;
    origin_x_m_ = view.min_x_m;
    origin_y_m_ = view.min_y_m;
  }
  if (view.resolution_m != resolution_m_)
    throw std::invalid_argument("TerrainMosaic: all views must have the same cell size");
  const std::int64_t column = nearest_cell(view.min_x_m - origin_x_m_, resolution_m_);
  const std::int64_t row = nearest_cell(view.min_y_m - origin_y_m_, resolution_m_);
  return {column, column + view.size, row, row + view.size};
}

RasterGrid DriveLattice::grid_of(const CellRange& cells) const {
  return {origin_x_m_ + static_cast<double>(cells.first_column) * resolution_m_,
          origin_y_m_ + static_cast<double>(cells.first_row) * resolution_m_, resolution_m_,
          cells.columns(), cells.rows()};
}

}  // namespace groundgrid::geotiff
