// Classification of ground cells, paper III-C, and the patch sums that III-D shares with it.
#include "core/ground_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace groundgrid {
namespace {

constexpr std::size_t kCellsPerTile = 1024;

/// Paper III-C: whether a cell has its share of the points expected by eq. 2.
bool has_enough_points(double points, double distance_m, const Config& config) {
  // atan(x) <= x settles most cells without the arc tangent.
  const double at_most =
      config.cell_size_m / distance_m * 180.0 / std::numbers::pi / config.point_angle_deg;
  return points >= config.min_point_fraction * at_most ||
         points >= config.min_point_fraction * expected_points(distance_m, config);
}

}  // namespace

double variance_threshold(double distance_m, const Config& config) {
  return std::max(config.variance_distance_factor * distance_m, config.min_variance_threshold);
}

double expected_points(double distance_m, const Config& config) {
  const double degrees = std::atan2(config.cell_size_m, distance_m) * 180.0 / std::numbers::pi;
  return degrees / config.point_angle_deg;
}

float SensorPositions::distance_to(float x, float y) const {
  float nearest = std::numeric_limits<float>::infinity();
  for (const Point3f& sensor : sensors) {
    const float dx = x - sensor.x;
    const float dy = y - sensor.y;
    nearest = std::min(nearest, dx * dx + dy * dy);
  }
  return std::sqrt(nearest);
}

GroundCells::GroundCells(std::size_t cells) : weighted_(cells), is_ground_(cells) {
  summarised_.reserve(cells);
  cells_.reserve(cells);
}

void GroundCells::summarise(const ScanGrid& grid, TileRunner& runner) {
  for (const std::uint32_t cell : summarised_) {
    weighted_[cell] = Weighted{};
    is_ground_[cell] = 0;
  }
  summarised_ = grid.occupied;
  cells_.assign(grid.occupied.size(), GroundCell{});
  const auto summarise_cells = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const CellStatistics& cell = grid.statistics[grid.occupied[i]];
      const auto points = static_cast<float>(cell.count);
      const auto variance = static_cast<float>(cell.variance_m2());
      weighted_[grid.occupied[i]] = {points, points * lowest_m(cell), points * variance, variance};
    }
  };
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile, summarise_cells);
}

GroundCells::Weighted GroundCells::sum_patch(int column, int row, int half, int size) const {
  Weighted sum;
  const int x_begin = std::max(column - half, 0);
  const int x_end = std::min(column + half, size - 1);
  for (int y = std::max(row - half, 0); y <= std::min(row + half, size - 1); ++y) {
    for (int x = x_begin; x <= x_end; ++x) {
      const Weighted& cell = weighted_[static_cast<std::size_t>(y * size + x)];
      sum.points += cell.points;
      sum.min_height += cell.min_height;
      sum.variance += cell.variance;
    }
  }
  return sum;
}

/// From the minima of the cells beside this one; an axis without both of them adds nothing.
float GroundCells::slope_squared(int column, int row, int size, float cell_size) const {
  const auto at = [&](int x, int y) -> const Weighted& {
    return weighted_[static_cast<std::size_t>(y * size + x)];
  };
  const auto slope = [cell_size](const Weighted& before, const Weighted& own,
                                 const Weighted& after) {
    if (!(before.points > 0.0F && after.points > 0.0F)) return 0.0F;
    return slope_along(before.min_height / before.points, own.min_height / own.points,
                       after.min_height / after.points, cell_size);
  };
  const Weighted& own = at(column, row);
  float squared = 0.0F;
  if (column > 0 && column < size - 1) {
    const float along_x = slope(at(column - 1, row), own, at(column + 1, row));
    squared += along_x * along_x;
  }
  if (row > 0 && row < size - 1) {
    const float along_y = slope(at(column, row - 1), own, at(column, row + 1));
    squared += along_y * along_y;
  }
  return squared;
}

void GroundCells::classify(const ScanGrid& grid, const ElevationMap& map,
                           const SensorPositions& sensors, const Config& config,
                           TileRunner& runner) {
  summarise(grid, runner);
  const int size = map.size();
  const auto cell_size = static_cast<float>(map.cell_size());
  const auto steepest = static_cast<float>(config.max_cell_slope * config.max_cell_slope);
  // A slope makes heights differ within a cell: points spread evenly over a width w that rises by
  // s · w have a variance of (s · w)² / 12.
  const float variance_per_slope = cell_size * cell_size / 12.0F;
  const auto is_smooth = [&](int column, int row, float variance, float threshold) {
    if (variance < threshold) return true;
    if (!(variance < threshold + steepest * variance_per_slope)) return false;
    const float slope = std::min(slope_squared(column, row, size, cell_size), steepest);
    return variance < threshold + slope * variance_per_slope;
  };
  const auto classify_cell = [&](std::size_t i) {
    const std::uint32_t cell = grid.occupied[i];
    const int row = static_cast<int>(cell) / size;
    const int column = static_cast<int>(cell) % size;
    const double distance =
        static_cast<double>(sensors.distance_to((static_cast<float>(column) + 0.5F) * cell_size,
                                                (static_cast<float>(row) + 0.5F) * cell_size));
    const int half = distance < config.patch_change_distance_m ? 1 : 2;
    const Weighted patch = sum_patch(column, row, half, size);
    const Weighted& own = weighted_[cell];

    GroundCell& answer = cells_[i];
    answer.patch_points = patch.points;
    answer.patch_elevation = patch.min_height / patch.points;
    const bool own_variance_counts =
        own.points >= static_cast<float>(config.own_variance_min_points);
    answer.variance = own_variance_counts ? own.own_variance : patch.variance / patch.points;

    answer.observed = has_enough_points(static_cast<double>(own.points), distance, config);
    answer.ground =
        answer.observed && is_smooth(column, row, answer.variance,
                                     static_cast<float>(variance_threshold(distance, config)));
    is_ground_[cell] = answer.ground ? 1 : 0;
  };
  const auto classify_cells = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) classify_cell(i);
  };
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile, classify_cells);
}

}  // namespace groundgrid
