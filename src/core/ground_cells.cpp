// Classification of ground cells, paper III-C, and the patch sums that III-D shares with it.
#include "core/ground_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

namespace groundgrid {
namespace {

constexpr std::size_t kCellsPerTile = 1024;
constexpr std::size_t kForgottenPerTile = 4096;

// More points than this are always enough.
constexpr std::size_t kMostListed = 65536;

/// The distance from which on a cell has its share of the points that are expected there.
double distance_where_enough(double points, const Config& config) {
  const double degrees = points / config.min_point_fraction * config.point_angle_deg;
  return config.cell_size_m / std::tan(degrees * std::numbers::pi / 180.0);
}

}  // namespace

GroundCells::GroundCells(std::size_t cells) : weighted_(cells), is_ground_(cells) {
  summarised_.reserve(cells);
  cells_.reserve(cells);
}

void GroundCells::summarise(const ScanGrid& grid, TileRunner& runner) {
  const auto forget = [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t cell : std::span(summarised_).subspan(begin, end - begin)) {
      weighted_[cell] = WeightedCell{};
      is_ground_[cell] = 0;
    }
  };
  runner.parallel_for_ranges(summarised_.size(), kForgottenPerTile, forget);
  summarised_ = grid.occupied;
  cells_.resize(grid.occupied.size());
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile,
                             [&](std::size_t begin, std::size_t end) {
                               weigh_cells(std::span(grid.occupied).subspan(begin, end - begin),
                                           grid.statistics.data(), weighted_.data());
                             });
}

/// Eq. 2 the other way round, once for all scans: from which distance on so many points are enough.
void GroundCells::list_enough(const Config& config) {
  if (config.min_point_fraction == enough_fraction_ && config.point_angle_deg == enough_angle_deg_)
    return;
  enough_fraction_ = config.min_point_fraction;
  enough_angle_deg_ = config.point_angle_deg;
  const double right_angle = 90.0 / config.point_angle_deg * config.min_point_fraction;
  enough_from_.clear();
  for (std::size_t points = 0; points < kMostListed && static_cast<double>(points) < right_angle;
       ++points) {
    const double distance = distance_where_enough(static_cast<double>(points), config);
    enough_from_.push_back(static_cast<float>(distance * distance));
  }
}

void GroundCells::classify(const ScanGrid& grid, const ElevationMap& map,
                           const SensorPositions& sensors, const Config& config, TileRunner& runner,
                           const std::uint8_t* supported) {
  summarise(grid, runner);
  list_enough(config);
  ClassRule rule;
  rule.cells = weighted_.data();
  rule.size = map.size();
  rule.cell_size = static_cast<float>(map.cell_size());
  rule.supported = supported;
  rule.sensors = sensors.sensors;
  rule.patch_change_squared =
      static_cast<float>(config.patch_change_distance_m * config.patch_change_distance_m);
  rule.own_variance_points = static_cast<float>(config.own_variance_min_points);
  rule.variance_per_metre = static_cast<float>(config.variance_distance_factor);
  rule.least_threshold = static_cast<float>(config.min_variance_threshold);
  rule.steepest_squared = static_cast<float>(config.max_cell_slope * config.max_cell_slope);
  rule.enough_from = enough_from_;
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile,
                             [&](std::size_t begin, std::size_t end) {
                               classify_cells(std::span(grid.occupied).subspan(begin, end - begin),
                                              rule, cells_.data() + begin, is_ground_.data());
                             });
}

}  // namespace groundgrid
