#include "groundgrid/terrain_view.hpp"

#include <limits>

namespace groundgrid {

TerrainCell TerrainView::cell(int column, int row) const {
  const auto index = static_cast<std::size_t>(row) * static_cast<std::size_t>(size) +
                     static_cast<std::size_t>(column);
  TerrainCell cell{};
  cell.height = z_origin_m + static_cast<double>(relative_height[index]);
  cell.confidence = confidence[index];
  const CellStatistics& points = statistics[index];
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
