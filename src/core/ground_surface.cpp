// The ground on the whole: what rises above it, and what it is where nothing was seen. Not in the
// paper.
#include "core/ground_surface.hpp"

#include "core/interpolation.hpp"

namespace groundgrid {

GroundSurface::GroundSurface(const ElevationMap& map)
    : fit_(map.size(), map.cell_size()), heights_(map.cells()), deviation_(map.cells()) {}

void GroundSurface::collect(const ScanGrid& grid, const GroundCells& ground_cells,
                            const ElevationMap& map, const Config& config) {
  heights_ = map.height();
  for (std::size_t i = 0; i < grid.occupied.size(); ++i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (seen.ground) heights_[grid.occupied[i]] = seen.patch_elevation;
  }
  const auto remembered = static_cast<float>(config.surface_min_confidence);
  fit_.clear();
  for (std::uint32_t cell = 0; cell < heights_.size(); ++cell)
    if (ground_cells.is_ground()[cell] != 0 || map.confidence()[cell] >= remembered)
      fit_.add(cell, heights_[cell]);
}

void GroundSurface::reject_raised(const ScanGrid& grid, const LocalPlane& ground,
                                  const Config& config, GroundCells& ground_cells,
                                  ElevationMap& map) {
  collect(grid, ground_cells, map, config);
  fit_.reject_raised(ground, config);
  for (const std::uint32_t cell : fit_.told())
    if (fit_.is_raised(cell)) map.confidence()[cell] = 0.0F;
  for (std::size_t i = 0; i < grid.occupied.size(); ++i)
    if (ground_cells.cells()[i].ground && fit_.is_raised(grid.occupied[i]))
      ground_cells.withdraw(i, grid.occupied[i]);
}

void GroundSurface::fill(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
                         const GroundCells& ground_cells, ElevationMap& map) {
  const std::vector<std::uint8_t>& is_ground = ground_cells.is_ground();
  fit_.fit(map.height(), ground);
  const auto follow = static_cast<float>(config.surface_follow_m);
  const auto decay = static_cast<float>(config.confidence_decay);
  for (std::uint32_t cell = 0; cell < heights_.size(); ++cell) {
    if (is_ground[cell] != 0) continue;
    map.confidence()[cell] = decayed_confidence(map.confidence()[cell], decay);
    if (fit_.is_ground(cell)) continue;
    float height = fit_.surface()[cell];
    // The ground is nowhere above the lowest return.
    if (grid.is_occupied[cell] != 0) {
      const float lowest = lowest_m(grid.statistics[cell]);
      if (lowest < height + follow) height = lowest;
    }
    map.height()[cell] = height;
  }
}

std::span<const float> GroundSurface::standard_deviation(const ScanGrid& grid,
                                                         const LocalPlane& ground,
                                                         const Config& config,
                                                         const GroundCells& ground_cells,
                                                         const ElevationMap& map) {
  if (!config.fit_surface) {
    collect(grid, ground_cells, map, config);
    fit_.fit(map.height(), ground);
  }
  fit_.standard_deviation(map.height(), config, deviation_);
  return deviation_;
}

}  // namespace groundgrid
