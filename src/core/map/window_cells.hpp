#pragma once

#include <algorithm>
#include <cstddef>

#include "core/map/elevation_map.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// The window's cells as single precision arithmetic sees them: the one rule by which points are
/// binned and rays walk, so that a point lies in the same cell for both.
struct WindowCells {
  float extent;
  float inverse_cell_size;
  int size;

  WindowCells(int cells_a_side, float resolution_m)
      : extent(static_cast<float>(cells_a_side) * resolution_m),
        inverse_cell_size(1.0F / resolution_m),
        size(cells_a_side) {}
  explicit WindowCells(const ElevationMap& map)
      : WindowCells(map.size(), static_cast<float>(map.cell_size())) {}

  /// Written so that NaN is outside.
  [[nodiscard]] bool contains(const Point3f& p) const {
    return p.x >= 0.0F && p.x < extent && p.y >= 0.0F && p.y < extent;
  }
  /// A window coordinate in cells.
  [[nodiscard]] float in_cells(float metres) const { return metres * inverse_cell_size; }
  /// Column of an x or row of a y inside; just inside the edge it may round to the cell outside.
  [[nodiscard]] int index_of(float metres) const {
    return std::min(static_cast<int>(in_cells(metres)), size - 1);
  }
};

/// The rows of cells that are asked for in ascending order, without a division for each.
class AscendingRows {
 public:
  explicit AscendingRows(std::size_t size, std::size_t first_cell = 0)
      : size_(size), row_(first_cell / size), end_((row_ + 1) * size) {}

  [[nodiscard]] std::size_t row_of(std::size_t cell) {
    for (; cell >= end_; end_ += size_) ++row_;
    return row_;
  }

 private:
  std::size_t size_;
  std::size_t row_;
  std::size_t end_;  // the first cell of the next row
};

}  // namespace groundgrid
