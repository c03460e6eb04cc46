#include "geotiff/mosaic_tile.hpp"

#include <algorithm>

#include "geotiff/saturating_sum.hpp"

namespace groundgrid::geotiff {
namespace {

// Most of a map has nothing to tell. Cells are asked this many at a time, and passed over together.
constexpr std::size_t kCellsAtOnce = 16;

bool any_known(std::span<const float> confidence) {
  std::uint32_t known = 0;
  for (const float cell : confidence) known |= cell > 0.0F ? 1U : 0U;
  return known != 0;
}

bool any_points(std::span<const std::uint32_t> points_around) {
  std::uint32_t points = 0;
  for (const std::uint32_t cell : points_around) points |= cell;
  return points != 0;
}

}  // namespace

void MosaicTile::add(std::size_t column, std::size_t row, const CellSpan& cells) {
  const std::size_t count = cells.confidence.size();
  for (std::size_t first = 0; first < count; first += kCellsAtOnce) {
    const std::size_t some = std::min(kCellsAtOnce, count - first);
    const std::size_t place = row * kSide + column + first;
    const auto confidences = cells.confidence.subspan(first, some);
    if (any_known(confidences))
      add_heights(place, cells.relative_height.subspan(first, some), confidences, cells.z_origin_m);
    const auto around = cells.points_around.subspan(first, some);
    if (any_points(around)) add_points(place, cells.statistics.subspan(first, some), around);
  }
}

void MosaicTile::add_heights(std::size_t place, std::span<const float> relative_heights,
                             std::span<const float> told, double z_origin_m) {
  double* const weighted_heights = weighted_height.data() + place;
  double* const weights = weight.data() + place;
  float* const confidences = confidence.data() + place;
  for (std::size_t i = 0; i < told.size(); ++i) {
    // A cell that is not known may hold any height, even none at all.
    if (!(told[i] > 0.0F)) continue;
    const auto weight_of_scan = static_cast<double>(told[i]);
    weighted_heights[i] += weight_of_scan * (z_origin_m + static_cast<double>(relative_heights[i]));
    weights[i] += weight_of_scan;
    confidences[i] = std::max(confidences[i], told[i]);
  }
}

void MosaicTile::add_points(std::size_t place, std::span<const CellStatistics> statistics,
                            std::span<const std::uint32_t> around) {
  std::uint32_t* const sums = points.data() + place;
  std::uint32_t* const densest = most_points_around.data() + place;
  for (std::size_t i = 0; i < around.size(); ++i) {
    sums[i] = saturating_sum(sums[i], statistics[i].count);
    densest[i] = std::max(densest[i], around[i]);
  }
}

}  // namespace groundgrid::geotiff
