// Ground elevation and confidence, paper III-D.
#include "core/stages/ground_elevation.hpp"

#include "core/method/equations.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kElevationsPerTile = 4096;

}  // namespace

void update_elevation(const ScanGrid& grid, const GroundCells& ground_cells, const Config& config,
                      TileRunner& runner, ElevationMap& map) {
  const auto update_cell = [&](std::size_t i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (!seen.observed) return;
    const std::uint32_t cell = grid.occupied[i];
    const CellEstimate known{map.height()[cell], map.confidence()[cell]};
    CellEstimate fused = lowered_by_obstacle(known, seen.patch_elevation);
    if (seen.ground) {
      const float q = observation_confidence(seen.patch_points, config);
      fused = {fused_height(known, seen.patch_elevation, q), fused_confidence(known.confidence, q)};
    }
    map.height()[cell] = fused.height;
    map.confidence()[cell] = fused.confidence;
  };
  const auto update_cells = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) update_cell(i);
  };
  runner.parallel_for_ranges(grid.occupied.size(), kElevationsPerTile, update_cells);
}

}  // namespace groundgrid
