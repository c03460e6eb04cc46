// The ground on the whole: what rises above it, and what it is where nothing was seen. Not in the
// paper.
#include "core/ground_surface.hpp"

#include <algorithm>
#include <cmath>

#include "core/interpolation.hpp"

namespace groundgrid {
namespace {

constexpr int kPasses = 3;
// Cells further below the surface than this are reflections: they lose weight too.
constexpr float kReflection_m = 0.5F;
// Raised cells belong together where they are at most so far apart, in cells, and so steep.
constexpr int kPatchReach = 2;
constexpr float kPatchSlope = 0.4F;
constexpr float kPatchStep_m = 0.02F;

}  // namespace

GroundSurface::GroundSurface(const ElevationMap& map)
    : size_(map.size()),
      cell_size_(static_cast<float>(map.cell_size())),
      planes_(map.size(), map.cell_size()),
      weights_(map.cells()),
      heights_(map.cells()),
      surface_(map.cells()),
      standing_(map.cells()) {
  known_.reserve(map.cells());
  patch_.reserve(map.cells());
}

void GroundSurface::collect(const ScanGrid& grid, const GroundCells& ground_cells,
                            const ElevationMap& map, const Config& config) {
  const auto remembered = static_cast<float>(config.surface_min_confidence);
  known_.clear();
  for (std::size_t cell = 0; cell < weights_.size(); ++cell) {
    const bool ground = ground_cells.is_ground()[cell] != 0;
    weights_[cell] = 0.0F;
    if (!ground && map.confidence()[cell] < remembered) continue;
    weights_[cell] = 1.0F;
    heights_[cell] = map.height()[cell];
    known_.push_back(static_cast<std::uint32_t>(cell));
  }
  for (std::size_t i = 0; i < grid.occupied.size(); ++i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (seen.ground) heights_[grid.occupied[i]] = seen.patch_elevation;
  }
}

void GroundSurface::reweight(const Config& config) {
  const auto tolerance = static_cast<float>(config.surface_tolerance_m);
  for (const std::uint32_t cell : known_) {
    const float above = heights_[cell] - surface_[cell];
    float ratio = 1.0F;
    if (above > tolerance) ratio = tolerance / above;
    if (above < -kReflection_m) ratio = -kReflection_m / above;
    weights_[cell] = ratio * ratio;
  }
}

void GroundSurface::find_raised(const Config& config) {
  std::fill(standing_.begin(), standing_.end(), Standing::unknown);
  const auto step = static_cast<float>(config.surface_step_m);
  for (const std::uint32_t cell : known_)
    standing_[cell] =
        heights_[cell] > surface_[cell] + step ? Standing::raised : Standing::on_surface;
}

/// Collects the raised cells that hang together with this one.
void GroundSurface::follow_raised(std::uint32_t seed) {
  patch_.assign(1, seed);
  standing_[seed] = Standing::judged;
  for (std::size_t next = 0; next < patch_.size(); ++next) {
    const std::uint32_t cell = patch_[next];
    const int row = static_cast<int>(cell) / size_;
    const int column = static_cast<int>(cell) % size_;
    for (int y = std::max(row - kPatchReach, 0); y <= std::min(row + kPatchReach, size_ - 1); ++y) {
      for (int x = std::max(column - kPatchReach, 0);
           x <= std::min(column + kPatchReach, size_ - 1); ++x) {
        const auto other = static_cast<std::uint32_t>(y * size_ + x);
        if (standing_[other] != Standing::raised) continue;
        const auto apart = static_cast<float>((x - column) * (x - column) + (y - row) * (y - row));
        const float rise = std::abs(heights_[other] - heights_[cell]);
        if (rise > kPatchStep_m + kPatchSlope * cell_size_ * std::sqrt(apart)) continue;
        standing_[other] = Standing::judged;
        patch_.push_back(other);
      }
    }
  }
}

/// A wide patch of ground cells not far above the surface is ground: a terrace, a bank, a garden
/// behind its wall. Walls, hedges and car roofs are narrower.
void GroundSurface::keep_plateaus(const Config& config) {
  const auto cells = static_cast<std::size_t>(
      config.plateau_area_m2 / (static_cast<double>(cell_size_) * static_cast<double>(cell_size_)));
  const auto highest = static_cast<float>(config.plateau_height_m);
  for (const std::uint32_t seed : known_) {
    if (standing_[seed] != Standing::raised) continue;
    follow_raised(seed);
    float sum = 0.0F;
    for (const std::uint32_t cell : patch_) sum += heights_[cell] - surface_[cell];
    const bool plateau = patch_.size() > cells && sum < highest * static_cast<float>(patch_.size());
    if (!plateau) continue;
    for (const std::uint32_t cell : patch_) standing_[cell] = Standing::on_surface;
  }
}

void GroundSurface::reject_raised(const ScanGrid& grid, const LocalPlane& ground,
                                  const Config& config, GroundCells& ground_cells,
                                  ElevationMap& map) {
  collect(grid, ground_cells, map, config);
  const std::size_t level = planes_.level_of(config.surface_block_m);
  for (int pass = 0; pass < kPasses; ++pass) {
    planes_.fit(weights_, heights_, ground, level);
    planes_.evaluate(level, surface_);
    reweight(config);
  }
  find_raised(config);
  keep_plateaus(config);
  for (const std::uint32_t cell : known_)
    if (standing_[cell] == Standing::judged) map.confidence()[cell] = 0.0F;
  for (std::size_t i = 0; i < grid.occupied.size(); ++i)
    if (ground_cells.cells()[i].ground && standing_[grid.occupied[i]] == Standing::judged)
      ground_cells.withdraw(i, grid.occupied[i]);
}

void GroundSurface::fill(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
                         const GroundCells& ground_cells, ElevationMap& map) {
  const std::vector<std::uint8_t>& is_ground = ground_cells.is_ground();
  for (std::size_t cell = 0; cell < weights_.size(); ++cell)
    weights_[cell] = standing_[cell] == Standing::on_surface ? 1.0F : 0.0F;
  planes_.fit(weights_, map.height(), ground, 0);
  planes_.evaluate(0, surface_);
  const auto follow = static_cast<float>(config.surface_follow_m);
  const auto decay = static_cast<float>(config.confidence_decay);
  for (std::size_t cell = 0; cell < weights_.size(); ++cell) {
    if (is_ground[cell] != 0) continue;
    map.confidence()[cell] = decayed_confidence(map.confidence()[cell], decay);
    if (weights_[cell] != 0.0F) continue;
    float height = surface_[cell];
    // The ground is nowhere above the lowest return.
    if (grid.is_occupied[cell] != 0) {
      const float lowest = lowest_m(grid.statistics[cell]);
      if (lowest < height + follow) height = lowest;
    }
    map.height()[cell] = height;
  }
}

}  // namespace groundgrid
