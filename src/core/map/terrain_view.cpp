#include "groundgrid/terrain_view.hpp"

#include <limits>
#include <stdexcept>

#include "core/map/cell_statistics.hpp"

namespace groundgrid {

double CellStatistics::mean_m() const {
  return static_cast<double>(sum) / static_cast<double>(count) * kStep_m;
}

double CellStatistics::variance_m2() const {
  const double per_point = 1.0 / static_cast<double>(count);
  const double mean = static_cast<double>(sum) * per_point;
  const double variance = static_cast<double>(sum_squares) * per_point - mean * mean;
  return (variance < 0.0 ? 0.0 : variance) * (kStep_m * kStep_m);
}

TerrainCell TerrainView::cell(int column, int row) const {
  if (column < 0 || column >= size || row < 0 || row >= size)
    throw std::out_of_range("TerrainView::cell: column and row must be in [0, size)");
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                     static_cast<std::size_t>(column);
  TerrainCell cell{};
  cell.height = z_origin_m + static_cast<double>(relative_height[index]);
  cell.confidence = confidence[index];
  const CellStatistics points = statistics != nullptr ? statistics[index] : CellStatistics{};
  cell.points = points.count;
  if (points.count == 0) {
    cell.variance = std::numeric_limits<float>::quiet_NaN();
    cell.lowest = cell.highest = std::numeric_limits<double>::quiet_NaN();
    return cell;
  }
  cell.variance = static_cast<float>(points.variance_m2());
  cell.lowest = z_origin_m + points.min * CellStatistics::kStep_m;
  cell.highest = z_origin_m + points.max * CellStatistics::kStep_m;
  return cell;
}

}  // namespace groundgrid
