// The stages of the default method in their order. What each does: reference_method.cpp.
#include "core/method/standard_method.hpp"

#include "core/stages/ground_elevation.hpp"
#include "core/stages/map_check.hpp"
#include "core/stages/outlier_filter.hpp"
#include "core/stages/segmentation.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kPointsAtOnce = 4096;

}  // namespace

StandardMethod::StandardMethod(const ElevationMap& map, TileRunner& runner)
    : runner_(&runner),
      support_(map),
      ground_cells_(map.cells()),
      surface_(map, runner),
      limits_(map, runner),
      step_edges_(map) {}

/// Bins and filters points, some thousand at once, which then are still near at hand for the next
/// step. One thread adds them to their cells at once, too.
void StandardMethod::rasterize(const Scan& scan, const Config& config, const ElevationMap& map,
                               BinnedPoints& bins, ScanGrid& grid) {
  clear(grid);
  const CellBand all{0, static_cast<std::uint32_t>(map.cells())};
  for (const SensorPass& pass : scan.sensors)
    runner_->parallel_for_ranges(
        pass.points.count, kPointsAtOnce, [&](std::size_t begin, std::size_t end) {
          bin_points(pass, {begin, end}, map, config, bins);
          filter_outliers(pass, {begin, end}, map, bins);
          if (runner_->threads() == 1)
            add_to_cells(bins, {pass.first + begin, pass.first + end}, all, grid);
        });
  if (runner_->threads() > 1)
    for_each_band(map.cells(), *runner_, [&](const CellBand& band, std::size_t) {
      add_to_cells(bins, {0, bins.cell.size()}, band, grid);
    });
  list_occupied(grid);
}

std::optional<LabelCounts> StandardMethod::process(const Scan& scan, const Config& config,
                                                   BinnedPoints& bins, ScanGrid& grid,
                                                   ElevationMap& map, const Answers& answers) {
  rasterize(scan, config, map, bins, grid);
  if (contradicts_map(bins, grid, map)) return std::nullopt;
  support_.find(bins, grid);
  ground_cells_.classify(grid, map, support_.is_supported(), scan.positions, *runner_);
  surface_.withdraw_raised(grid, scan.ground, ground_cells_, map);
  surface_.accept_lone(grid, ground_cells_);
  update_elevation(grid, ground_cells_, config, *runner_, map);
  map.mark_observed();
  surface_.fill(grid, scan.ground, config, ground_cells_, map);
  limits_.choose_by_column(bins, grid, map, config, *runner_);
  if (config.labels.max_step_m > 0.0)
    step_edges_.lower_limits(bins, grid, config, *runner_, limits_.limits());
  return segment(bins, limits_, map, config, *runner_, answers.labels, answers.height_above_ground);
}

}  // namespace groundgrid
