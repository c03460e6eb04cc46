#pragma once

#include <algorithm>

#include "core/elevation_map.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// The window's cells as single precision arithmetic sees them: the one rule by which points are
/// binned and rays walk, so that a point lies in the same cell for both.
struct WindowCells {
  float extent;
  float inverse_cell_size;
  int size;

  explicit WindowCells(const ElevationMap& map)
      : extent(static_cast<float>(map.size()) * static_cast<float>(map.cell_size())),
        inverse_cell_size(1.0F / static_cast<float>(map.cell_size())),
        size(map.size()) {}

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

}  // namespace groundgrid
