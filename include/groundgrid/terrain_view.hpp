#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
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

/// Exact moments of the heights of one cell's points in one scan. Heights are whole steps of
/// 0.1 mm above TerrainView::z_origin_m, so that sums are exact and no order of the points, no
/// number of threads and no instruction set changes a bit (paper III-B uses Welford's method).
struct GROUNDGRID_EXPORT CellStatistics {
  static constexpr double kStep_m = 1e-4;

  alignas(32) std::int64_t sum = 0;  ///< Sum of heights, steps. Two cells to a cache line.
  std::uint64_t sum_squares = 0;     ///< Sum of squared heights, steps².
  /// Lowest and highest height, steps; without points the highest and the lowest number there is.
  std::int32_t min = std::numeric_limits<std::int32_t>::max();
  std::int32_t max = std::numeric_limits<std::int32_t>::min();
  std::uint32_t count = 0;  ///< Number of points.

  /// Mean height in metres above the origin; NaN without points.
  [[nodiscard]] double mean_m() const;
  /// Population variance in m²; NaN without points.
  [[nodiscard]] double variance_m2() const;
};

/// A read-only view of the rolling map: size × size square cells, row by row, x fastest.
/// Cell (column, row) covers [min_x_m + column·cell_size_m, …) × [min_y_m + row·cell_size_m, …)
/// of the map frame. Valid until the next process() or reset() of the GroundGrid it came from.
struct GROUNDGRID_EXPORT TerrainView {
  int size = 0;                              ///< Cells along x and along y.
  double cell_size_m = 0.0;                  ///< Length of a cell's side.
  double min_x_m = 0.0;                      ///< Map frame x of the outer edge of column 0.
  double min_y_m = 0.0;                      ///< Map frame y of the outer edge of row 0.
  double z_origin_m = 0.0;                   ///< Map frame z of height 0 in `relative_height`.
  std::span<const float> relative_height{};  ///< Ground height less z_origin_m, m.
  std::span<const float> confidence{};       ///< 0 to 1.
  std::span<const CellStatistics> statistics{};

  /// One cell. Throws std::out_of_range where column or row is not in [0, size).
  [[nodiscard]] TerrainCell cell(int column, int row) const;
};

}  // namespace groundgrid
