// Ground elevation and confidence, paper III-D.
#include "core/ground_elevation.hpp"

#include <algorithm>

namespace groundgrid {
namespace {

constexpr std::size_t kElevationsPerTile = 4096;
// Paper III-D: what an obstacle cell below the known ground adds to the confidence, and up to
// where.
constexpr float kObstacleConfidenceStep = 0.1F;
constexpr float kObstacleConfidenceLimit = 0.5F;

}  // namespace

float observation_confidence(float patch_points, const Config& config) {
  return std::clamp(patch_points / static_cast<float>(config.confidence_point_scale), 0.0F, 1.0F);
}

CellEstimate fuse_ground(const CellEstimate& known, float elevation, float confidence) {
  const float weight = confidence + known.confidence;
  CellEstimate fused = known;
  if (weight > 0.0F)
    fused.height = (confidence * elevation + known.confidence * known.height) / weight;
  fused.confidence = 0.5F * (0.5F * confidence + known.confidence);
  return fused;
}

CellEstimate fuse_obstacle(const CellEstimate& known, float elevation) {
  if (elevation >= known.height) return known;
  return {elevation,
          std::min(known.confidence + kObstacleConfidenceStep, kObstacleConfidenceLimit)};
}

void update_elevation(const ScanGrid& grid, const GroundCells& ground_cells, const Config& config,
                      TileRunner& runner, ElevationMap& map) {
  const auto update_cell = [&](std::size_t i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (!seen.observed) return;
    const std::uint32_t cell = grid.occupied[i];
    const CellEstimate known{map.height()[cell], map.confidence()[cell]};
    const CellEstimate fused = seen.ground
                                   ? fuse_ground(known, seen.patch_elevation,
                                                 observation_confidence(seen.patch_points, config))
                                   : fuse_obstacle(known, seen.patch_elevation);
    map.height()[cell] = fused.height;
    map.confidence()[cell] = fused.confidence;
  };
  const auto update_cells = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) update_cell(i);
  };
  runner.parallel_for_ranges(grid.occupied.size(), kElevationsPerTile, update_cells);
}

}  // namespace groundgrid
