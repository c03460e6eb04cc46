// Point cloud segmentation, paper III-F.
#include "core/segmentation.hpp"

#include <atomic>
#include <cstdint>

namespace groundgrid {
namespace {

constexpr std::size_t kLabelsPerTile = 8192;
constexpr auto kHeightStep_m = static_cast<float>(CellStatistics::kStep_m);

}  // namespace

LabelCounts segment(const BinnedPoints& bins, const CellLimits& limits, const ElevationMap& map,
                    TileRunner& runner, std::span<Label> labels,
                    std::span<float> height_above_ground) {
  // Whole numbers come to the same sum in any order.
  std::atomic<std::size_t> ground{0}, obstacle{0}, outlier{0};
  const auto segment_points = [&](std::size_t begin, std::size_t end) {
    std::uint32_t outliers[kLabelsPerTile + kSpareIndices];
    const LabelCounts counts =
        label_points({bins.cell.data() + begin, bins.z.data() + begin, end - begin},
                     &limits.limits().data()->level, labels.data() + begin,
                     height_above_ground.data() + begin, outliers);
    for (std::size_t k = 0; k < counts.outlier; ++k) {
      const std::size_t i = begin + outliers[k];
      const std::uint32_t cell = bins.cell[i] & ~BinnedPoints::kOutlier;
      labels[i] = Label::outlier;
      height_above_ground[i] = static_cast<float>(bins.z[i]) * kHeightStep_m - map.height()[cell];
    }
    ground += counts.ground;
    obstacle += counts.obstacle;
    outlier += counts.outlier;
  };
  runner.parallel_for_ranges(bins.cell.size(), kLabelsPerTile, segment_points);
  return {ground, obstacle, outlier, bins.cell.size() - ground - obstacle - outlier};
}

}  // namespace groundgrid
