// Point cloud segmentation, paper III-F.
#include "core/segmentation.hpp"

#include <algorithm>
#include <limits>

namespace groundgrid {
namespace {

constexpr std::size_t kLabelsPerTile = 8192;

}  // namespace

void segment(const BinnedPoints& bins, const CellLimits& limits, const ElevationMap& map,
             TileRunner& runner, std::span<Label> labels, std::span<float> height_above_ground) {
  constexpr auto kHeightStep_m = static_cast<float>(CellStatistics::kStep_m);
  const CellLimit* limit_of = limits.limits().data();
  const auto segment_points = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t cell = bins.cell[i];
      if (cell == BinnedPoints::kNoCell) {
        height_above_ground[i] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      const float z = static_cast<float>(bins.z[i]) * kHeightStep_m;
      if (labels[i] == Label::outlier) {
        height_above_ground[i] = z - map.height()[cell];
        continue;
      }
      const CellLimit limit = limit_of[cell];
      const float above = z - limit.level;
      height_above_ground[i] = above;
      labels[i] = above <= limit.threshold ? Label::ground : Label::obstacle;
    }
  };
  runner.parallel_for_ranges(bins.cell.size(), kLabelsPerTile, segment_points);
}

}  // namespace groundgrid
