#pragma once

#include <cstdint>
#include <span>

#include "groundgrid/export.hpp"

namespace groundgrid {

/// What the map knows about one cell. Heights in metres, in the map frame.
struct TerrainCell {
  double height;         ///< Estimated ground height.
  float confidence;      ///< 0 (never seen, extrapolated) to 1 (paper eq. 6 and 8).
  float variance;        ///< Variance of z of the last scan's points in the cell, m²; NaN if none.
  double lowest;         ///< Lowest point of the last scan; NaN if none.
  double highest;        ///< Highest point of the last scan; NaN if none.
  std::uint32_t points;  ///< Number of points of the last scan in the cell.
};

struct CellStatistics;  // The library's own sums; TerrainView::cell() gives them in metres.

/// A read-only view of the rolling map: size × size square cells, row by row, x fastest.
/// Cell (column, row) covers [min_x_m + column·resolution_m, …) × [min_y_m + row·resolution_m, …)
/// of the map frame. Valid until the next process() or reset() of the GroundGrid it came from.
struct GROUNDGRID_EXPORT TerrainView {
  int size = 0;                                ///< Cells along x and along y.
  double resolution_m = 0.0;                   ///< Length of a cell's side.
  double min_x_m = 0.0;                        ///< Map frame x of the outer edge of column 0.
  double min_y_m = 0.0;                        ///< Map frame y of the outer edge of row 0.
  double z_origin_m = 0.0;                     ///< Map frame z of height 0 in `relative_height`.
  std::span<const float> relative_height{};    ///< Ground height less z_origin_m, m.
  std::span<const float> confidence{};         ///< 0 to 1.
  const CellStatistics* statistics = nullptr;  ///< Of size × size cells; see cell().

  /// One cell. Throws std::out_of_range if column or row is not in [0, size).
  [[nodiscard]] TerrainCell cell(int column, int row) const;
};

}  // namespace groundgrid
