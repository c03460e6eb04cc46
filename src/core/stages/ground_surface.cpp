// The ground on the whole: what rises above it, and what it is where nothing was seen. Not in the
// paper.
#include "core/stages/ground_surface.hpp"

#include <algorithm>

#include "core/kernels/surface_kernels.hpp"
#include "core/method/constants.hpp"

namespace groundgrid {

namespace {

constexpr std::size_t kOccupiedPerTile = 4096;
constexpr std::size_t kWindowCellsPerTile = 32768;

}  // namespace

GroundSurface::GroundSurface(const ElevationMap& map, TileRunner& runner)
    : runner_(&runner), fit_(map.size(), map.cell_size(), runner), deviation_(map.cells()) {}

void GroundSurface::collect(const ScanGrid& grid, const GroundCells& ground_cells,
                            const ElevationMap& map) {
  const std::span<float> heights = fit_.heights();
  const auto take_elevations = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      heights[grid.occupied[i]] = ground_cells.cells()[i].patch_elevation;
  };
  runner_->parallel_for_ranges(grid.occupied.size(), kOccupiedPerTile, take_elevations);
  const auto take_known = [&](std::size_t begin, std::size_t end) {
    const auto part = [&](auto& cells) { return std::span(cells).subspan(begin, end - begin); };
    collect_known(part(ground_cells.is_ground()), part(map.height()), part(map.confidence()),
                  constants::kRemembered, part(heights));
  };
  runner_->parallel_for_ranges(heights.size(), kWindowCellsPerTile, take_known);
}

void GroundSurface::withdraw_raised(const ScanGrid& grid, const LocalPlane& ground,
                                    GroundCells& ground_cells, ElevationMap& map) {
  collect(grid, ground_cells, map);
  fit_.reject_raised(ground);
  for (const std::uint32_t cell : fit_.raised()) map.confidence()[cell] = 0.0F;
  const auto withdraw = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      if (ground_cells.cells()[i].ground && fit_.is_raised(grid.occupied[i]))
        ground_cells.withdraw(i, grid.occupied[i]);
  };
  runner_->parallel_for_ranges(grid.occupied.size(), kOccupiedPerTile, withdraw);
}

void GroundSurface::accept_lone(const ScanGrid& grid, GroundCells& ground_cells) {
  const auto accept = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const GroundCell& seen = ground_cells.cells()[i];
      if (seen.lone && fit_.accept(grid.occupied[i], seen.patch_elevation))
        ground_cells.accept(i, grid.occupied[i]);
    }
  };
  runner_->parallel_for_ranges(grid.occupied.size(), kOccupiedPerTile, accept);
}

void GroundSurface::fill(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
                         const GroundCells& ground_cells, ElevationMap& map) {
  const std::vector<std::uint8_t>& is_ground = ground_cells.is_ground();
  fit_.fit(map.height(), ground);
  const auto size = static_cast<std::size_t>(map.size());
  const auto decay = static_cast<float>(config.map.confidence_decay);
  fit_.for_each_row([&](std::size_t row, const SurfaceBetween& along) {
    const std::size_t first = row * size;
    fill_cells({is_ground.data() + first, fit_.standing().data() + first, &along,
                map.height().data() + first, map.confidence().data() + first, size},
               decay);
  });
  follow_lowest(grid, is_ground, map);
}

/// The ground is nowhere above the lowest return.
void GroundSurface::follow_lowest(const ScanGrid& grid, const std::vector<std::uint8_t>& is_ground,
                                  ElevationMap& map) {
  float* heights = map.height().data();
  const auto follow_cells = [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t cell : std::span(grid.occupied).subspan(begin, end - begin)) {
      if (is_ground[cell] != 0 || fit_.is_ground(cell)) continue;
      const float lowest = lowest_m(grid.statistics[cell]);
      if (lowest < heights[cell] + constants::kFollow_m) heights[cell] = lowest;
    }
  };
  runner_->parallel_for_ranges(grid.occupied.size(), kOccupiedPerTile, follow_cells);
}

void GroundSurface::fit_known(const std::vector<std::uint8_t>& is_known, float min_confidence,
                              const LocalPlane& ground, const ElevationMap& map) {
  std::copy(map.height().begin(), map.height().end(), fit_.heights().begin());
  collect_known(is_known, map.height(), map.confidence(), min_confidence, fit_.heights());
  fit_.accept_all();
  fit_.fit(map.height(), ground);
}

std::span<const float> GroundSurface::standard_deviation(const ElevationMap& map) {
  fit_.standard_deviation(map.height(), deviation_);
  return deviation_;
}

}  // namespace groundgrid
