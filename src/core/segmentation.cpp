// Point cloud segmentation, paper III-F.
#include "core/segmentation.hpp"

#include <algorithm>
#include <limits>

namespace groundgrid {
namespace {

constexpr std::size_t kPointsPerTile = 8192;

}  // namespace

void segment(const BinnedPoints& bins, const std::vector<std::uint8_t>& is_ground,
             const ElevationMap& map, const Config& config, TileRunner& runner,
             std::span<Label> labels, std::span<float> height_above_ground) {
  const float thresholds[2] = {static_cast<float>(config.obstacle_threshold_m),
                               static_cast<float>(config.ground_threshold_m)};
  const auto step = static_cast<float>(CellStatistics::kStep_m);
  const float* height = map.height().data();
  const auto segment_tile = [&](std::size_t tile) {
    const std::size_t end = std::min((tile + 1) * kPointsPerTile, bins.cell.size());
    for (std::size_t i = tile * kPointsPerTile; i < end; ++i) {
      const std::uint32_t cell = bins.cell[i];
      if (cell == BinnedPoints::kNoCell) {
        height_above_ground[i] = std::numeric_limits<float>::quiet_NaN();
        continue;
      }
      const float above = static_cast<float>(bins.z[i]) * step - height[cell];
      height_above_ground[i] = above;
      if (labels[i] == Label::outlier) continue;
      labels[i] = above <= thresholds[is_ground[cell]] ? Label::ground : Label::obstacle;
    }
  };
  runner.parallel_for_tiles((bins.cell.size() + kPointsPerTile - 1) / kPointsPerTile, segment_tile);
}

}  // namespace groundgrid
