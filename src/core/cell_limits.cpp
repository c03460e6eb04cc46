// The thresholds of the point cloud segmentation, paper III-F, chosen cell by cell.
#include "core/cell_limits.hpp"

#include <algorithm>
#include <cmath>

namespace groundgrid {
namespace {

constexpr std::size_t kLimitsPerTile = 1024;
constexpr float kStep_m = static_cast<float>(CellStatistics::kStep_m);
// Ground points lie at most this far below the map's height; deeper ones are reflections.
constexpr double kBandBelow_m = 0.3;
// One cell counts like at most this many points, so that a dense one does not outvote the rest.
constexpr float kCellWeight = 20.0F;
// Weight of "no offset", in points.
constexpr float kNoOffsetWeight = 3.0F;

/// Heights that leave 32 bits are cut off: no point is that far from the z origin.
std::int32_t steps(double metres) {
  constexpr double kMost = 1e9;
  return static_cast<std::int32_t>(
      std::lround(std::clamp(metres / CellStatistics::kStep_m, -kMost, kMost)));
}

}  // namespace

void CellLimits::choose_by_class(const ScanGrid& grid, const std::vector<std::uint8_t>& is_ground,
                                 const ElevationMap& map, const Config& config) {
  const auto ground = static_cast<float>(config.ground_threshold_m);
  const auto obstacle = static_cast<float>(config.obstacle_threshold_m);
  for (const std::uint32_t cell : grid.occupied)
    limits_[cell] = {map.height()[cell], is_ground[cell] != 0 ? ground : obstacle};
}

void CellLimits::collect_columns(const BinnedPoints& bins, std::span<const Label> labels,
                                 const ScanGrid& grid, const ElevationMap& map,
                                 const Config& config, TileRunner& runner) {
  for (const std::uint32_t cell : collected_) offsets_[cell] = Offset{};
  collected_ = grid.occupied;
  for (const std::uint32_t cell : grid.occupied)
    columns_[cell] = {steps(static_cast<double>(map.height()[cell])), 0, 0, 0};

  const std::int32_t tall = steps(config.tall_height_m);
  const std::int32_t overhang = steps(config.overhang_height_m);
  const std::int32_t band_below = steps(kBandBelow_m);
  const std::int32_t band_above = steps(config.level_band_m);
  for_each_binned_point(bins, labels, map.cells(), runner, [&](std::uint32_t cell, std::int32_t z) {
    Column& column = columns_[cell];
    const std::int32_t above = z - column.height;
    if (above > -band_below && above < band_above) {
      ++column.near_ground;
      column.near_ground_sum += above;
    } else if (above > tall && above < overhang) {
      ++column.rising;
    }
  });
  // Where something stands its feet would pass for ground: such cells take the level of others.
  for (const std::uint32_t cell : grid.occupied) {
    const Column& column = columns_[cell];
    if (grid.statistics[cell].max - column.height > tall) continue;
    const float share = 1.0F / (1.0F + static_cast<float>(column.near_ground) / kCellWeight);
    offsets_[cell] = {share * static_cast<float>(column.near_ground),
                      share * static_cast<float>(column.near_ground_sum)};
  }
}

float CellLimits::mean_offset(int column, int row, int size) const {
  const Offset& own = offsets_[static_cast<std::size_t>(row * size + column)];
  // The cell itself counts three times: twice here and once among its neighbours.
  float weight = kNoOffsetWeight + 2.0F * own.weight;
  float sum = 2.0F * own.weighted_steps;
  const int x_begin = std::max(column - 2, 0);
  const int x_end = std::min(column + 2, size - 1);
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, size - 1); ++y) {
    for (int x = x_begin; x <= x_end; ++x) {
      const Offset& seen = offsets_[static_cast<std::size_t>(y * size + x)];
      weight += seen.weight;
      sum += seen.weighted_steps;
    }
  }
  return sum / weight * kStep_m;
}

/// Whether something stands in the column, and not only a blade of grass or two.
bool CellLimits::rises(const Column& column, const Config& config) {
  return column.rising > 0 &&
         static_cast<double>(column.rising) > config.tall_min_share * column.near_ground;
}

void CellLimits::choose_by_column(const BinnedPoints& bins, std::span<const Label> labels,
                                  const ScanGrid& grid, const ElevationMap& map,
                                  const Config& config, TileRunner& runner) {
  collect_columns(bins, labels, grid, map, config, runner);
  const auto free_threshold = static_cast<float>(config.ground_threshold_m);
  const auto tall_threshold = static_cast<float>(config.tall_threshold_m);
  const int size = map.size();
  const auto choose = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::uint32_t cell = grid.occupied[i];
      const int row = static_cast<int>(cell) / size;
      const int column = static_cast<int>(cell) % size;
      limits_[cell] = {map.height()[cell] + mean_offset(column, row, size),
                       rises(columns_[cell], config) ? tall_threshold : free_threshold};
    }
  };
  runner.parallel_for_ranges(grid.occupied.size(), kLimitsPerTile, choose);
}

}  // namespace groundgrid
