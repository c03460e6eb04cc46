#include "geotiff/mosaic_tile.hpp"

#include <algorithm>

#include "geotiff/saturating_sum.hpp"

namespace groundgrid::geotiff {

void MosaicTile::add(std::size_t column, std::size_t row, const CellSpan& cells) {
  const std::size_t first = row * kSide + column;
  const std::size_t count = cells.confidence.size();
  double* const weighted_heights = weighted_height.data() + first;
  double* const weights = weight.data() + first;
  float* const confidences = confidence.data() + first;
  std::uint32_t* const sums = points.data() + first;
  for (std::size_t i = 0; i < count; ++i) {
    // A cell that is not known may hold any height, even none at all.
    const bool known = cells.confidence[i] > 0.0F;
    const float seen = known ? cells.confidence[i] : 0.0F;
    const double height =
        known ? cells.z_origin_m + static_cast<double>(cells.relative_height[i]) : 0.0;
    weighted_heights[i] += static_cast<double>(seen) * height;
    weights[i] += static_cast<double>(seen);
    confidences[i] = std::max(confidences[i], seen);
  }
  std::uint32_t* const densest = most_points_around.data() + first;
  for (std::size_t i = 0; i < count; ++i) {
    sums[i] = saturating_sum(sums[i], cells.statistics[i].count);
    densest[i] = std::max(densest[i], cells.points_around[i]);
  }
}

}  // namespace groundgrid::geotiff
