// Steps of the ground, such as kerbs, as obstacles. Not in the paper.
#include "core/stages/step_edges.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace groundgrid {
namespace {

// The sides of a step are next to its cell. How steep they are shows from there to the cells two
// further on, as far as the sides are from each other.
constexpr int kSideAway = 1;
constexpr int kBeyondAway = 3;
// Cells with more points than this count no more.
constexpr std::uint32_t kMostPoints = 20;
// Few points may scatter less by chance than a lidar's do on flat ground. (m²)
constexpr float kLeastVariance_m2 = 1e-4F;
// Fewer points than this in a cell do not tell how they scatter.
constexpr std::uint32_t kScatterPoints = 4;
constexpr float kScatterShare = 0.3F;
// A kerb is long: so many cells around must rise like a cell, at least by this share of the limit.
constexpr int kCellsAlike = 2;
constexpr float kAlikeShare = 0.5F;

}  // namespace

void StepEdges::collect(const BinnedPoints& bins, const ScanGrid& grid, TileRunner& runner,
                        std::span<const CellLimit> limits) {
  constexpr auto kStep_m = static_cast<float>(CellStatistics::kStep_m);
  const auto cells = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  moments_.resize(cells);
  levels_.resize(cells);
  steps_.resize(cells);
  collected_.reserve(cells);
  for (const std::uint32_t cell : collected_) {
    moments_[cell] = {};
    levels_[cell] = {};
    steps_[cell] = {};
  }
  collected_ = grid.occupied;
  for_each_binned_point(bins, cells, runner, [&](std::uint32_t cell, std::int32_t z) {
    const CellLimit limit = limits[cell];
    if (static_cast<float>(z) * kStep_m - limit.level > limit.threshold) return;
    Moments& moments = moments_[cell];
    moments.sum += z;
    moments.sum_squares += static_cast<std::uint64_t>(std::int64_t{z} * z);
    ++moments.count;
  });
  for (const std::uint32_t cell : collected_) {
    const Moments& moments = moments_[cell];
    if (moments.count == 0) continue;
    CellStatistics statistics;
    statistics.sum = moments.sum;
    statistics.sum_squares = moments.sum_squares;
    statistics.count = moments.count;
    levels_[cell] = {static_cast<float>(statistics.mean_m()),
                     static_cast<float>(statistics.variance_m2()), moments.count};
  }
}

StepEdges::Level StepEdges::level_at(int column, int row) const {
  if (column < 0 || row < 0 || column >= size_ || row >= size_) return {};
  return levels_[static_cast<std::size_t>(row * size_ + column)];
}

StepEdges::Profile StepEdges::profile_along(int column, int row, Direction along) const {
  const auto level = [&](int away) {
    return level_at(column + away * along.x, row + away * along.y);
  };
  const Level before = level(-kSideAway);
  const Level after = level(kSideAway);
  const std::uint32_t points = std::min({before.count, after.count, kMostPoints});
  if (points == 0) return {};
  const Level first = level(-kBeyondAway);
  const Level last = level(kBeyondAway);
  if (first.count == 0 && last.count == 0) return {};
  Profile profile;
  profile.before = before.mean;
  profile.rise = after.mean - before.mean;
  if (first.count > 0) profile.slope += before.mean - first.mean;
  if (last.count > 0) profile.slope += last.mean - after.mean;
  if (first.count > 0 && last.count > 0) profile.slope *= 0.5F;
  profile.scatter =
      std::max(before.variance, kLeastVariance_m2) + std::max(after.variance, kLeastVariance_m2);
  profile.weight = static_cast<float>(points);
  return profile;
}

/// The mean of the profiles of the cell and its neighbours on both sides of the direction. Whole
/// profiles, so that a slope does not tilt it where a cell was not seen.
StepEdges::Step StepEdges::step_along(int column, int row, Direction along) const {
  Profile mean;
  float profiles = 0.0F;
  for (int i = -1; i <= 1; ++i) {
    const Profile profile = profile_along(column - i * along.y, row + i * along.x, along);
    if (profile.weight == 0.0F) continue;
    mean.before += profile.weight * profile.before;
    mean.rise += profile.weight * profile.rise;
    mean.slope += profile.weight * profile.slope;
    mean.scatter += profile.weight * profile.scatter;
    mean.weight += profile.weight;
    profiles += 1.0F;
  }
  if (profiles == 0.0F) return {};
  const bool falls = mean.rise < 0.0F;
  const float start = mean.before / mean.weight;
  const float end = start + mean.rise / mean.weight;
  const float low = std::min(start, end);
  const float high = std::max(start, end);
  const float slope = std::max((falls ? -mean.slope : mean.slope) / mean.weight, 0.0F);
  // On a ramp or slope the cell between lies half way up without scattering as at a step.
  const Level own = level_at(column, row);
  if (own.count >= kScatterPoints &&
      own.variance < kScatterShare * (own.mean - low) * (high - own.mean))
    return {};
  // The points of a cell are no independent measurements, the cells are.
  const float chance = std::sqrt(mean.scatter / mean.weight / profiles);
  return {high - low - slope - chance, low, falls ? 4 : 0};
}

StepEdges::Step StepEdges::highest_step(std::uint32_t cell) const {
  constexpr std::array<Direction, 4> kDirections{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
  const int row = static_cast<int>(cell) / size_;
  const int column = static_cast<int>(cell) % size_;
  Step highest;
  int eighths = 0;
  for (const Direction& along : kDirections) {
    Step step = step_along(column, row, along);
    step.towards += eighths++;
    if (step.height > highest.height) highest = step;
  }
  return highest;
}

bool StepEdges::goes_on(std::uint32_t cell, float max_step) const {
  const int row = static_cast<int>(cell) / size_;
  const int column = static_cast<int>(cell) % size_;
  int alike = 0;
  for (int y = std::max(row - 1, 0); y <= std::min(row + 1, size_ - 1); ++y) {
    for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size_ - 1); ++x) {
      if (x == column && y == row) continue;
      const Step& other = steps_[static_cast<std::size_t>(y * size_ + x)];
      // 7, 0 or 1 eighths of a turn apart.
      const bool same_way = (other.towards - steps_[cell].towards + 9) % 8 <= 2;
      if (same_way && other.height > kAlikeShare * max_step) ++alike;
    }
  }
  return alike >= kCellsAlike;
}

void StepEdges::lower_limits(const BinnedPoints& bins, const ScanGrid& grid, const Config& config,
                             TileRunner& runner, std::span<CellLimit> limits) {
  collect(bins, grid, runner, limits);
  const auto find_steps = [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) steps_[collected_[i]] = highest_step(collected_[i]);
  };
  runner.parallel_for_ranges(collected_.size(), kCellsPerTile, find_steps);
  const auto max_step = static_cast<float>(config.labels.max_step_m);
  for (const std::uint32_t cell : collected_)
    if (steps_[cell].height > max_step && goes_on(cell, max_step))
      limits[cell].lower_to(steps_[cell].low + 0.5F * max_step);
}

}  // namespace groundgrid
