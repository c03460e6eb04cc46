// Point cloud segmentation, paper III-F.
#include "core/stages/segmentation.hpp"

#include <atomic>
#include <cstdint>
#include <utility>

#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kLabelsPerTile = 8192;
constexpr auto kHeightStep_m = static_cast<float>(CellStatistics::kStep_m);

/// A point that had no part in the terrain: an outlier if it lies deep below it.
Label label_set_aside(float height_above_ground, const Config& config) {
  const auto height = static_cast<double>(height_above_ground);
  if (height <= -constants::kReflectionDepth_m) return Label::outlier;
  return height <= config.labels.ground_threshold_m ? Label::ground : Label::obstacle;
}

}  // namespace

LabelCounts segment(const BinnedPoints& bins, const CellLimits& limits, const ElevationMap& map,
                    const Config& config, TileRunner& runner, std::span<Label> labels,
                    std::span<float> height_above_ground) {
  // Whole numbers come to the same sum in any order.
  std::atomic<std::size_t> ground{0}, obstacle{0}, outlier{0};
  const auto segment_points = [&](std::size_t begin, std::size_t end) {
    std::uint32_t set_aside[kLabelsPerTile + kSpareIndices];
    LabelCounts counts =
        label_points({bins.cell.data() + begin, bins.z.data() + begin, end - begin},
                     &limits.limits().data()->level, labels.data() + begin,
                     height_above_ground.data() + begin, set_aside);
    for (const std::uint32_t found : std::span(set_aside, std::exchange(counts.outlier, 0))) {
      const std::size_t i = begin + found;
      const std::uint32_t cell = bins.cell[i] & ~BinnedPoints::kOutlier;
      height_above_ground[i] = static_cast<float>(bins.z[i]) * kHeightStep_m - map.height()[cell];
      labels[i] = label_set_aside(height_above_ground[i], config);
      ++(labels[i] == Label::outlier  ? counts.outlier
         : labels[i] == Label::ground ? counts.ground
                                      : counts.obstacle);
    }
    ground += counts.ground;
    obstacle += counts.obstacle;
    outlier += counts.outlier;
  };
  runner.parallel_for_ranges(bins.cell.size(), kLabelsPerTile, segment_points);
  return {ground, obstacle, outlier, bins.cell.size() - ground - obstacle - outlier};
}

}  // namespace groundgrid
