#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <span>

#include "groundgrid/terrain_view.hpp"

namespace groundgrid {

/// Exact moments of the heights of one cell's points in one scan. Heights are whole steps of
/// 0.1 mm above TerrainView::z_origin_m, so that sums are exact and no order of the points, no
/// number of threads and no instruction set changes a bit (paper III-B uses Welford's method).
struct CellStatistics {
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

/// Of all cells of a view.
inline std::span<const CellStatistics> statistics_of(const TerrainView& view) {
  const auto size = view.statistics != nullptr ? static_cast<std::size_t>(view.size) : 0;
  return {view.statistics, size * size};
}

}  // namespace groundgrid
