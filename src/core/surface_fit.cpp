// The ground on the whole: what stands on it, what it is where nothing was seen, how far off it may
// be. Not in the paper.
#include "core/surface_fit.hpp"

#include <algorithm>
#include <cmath>

namespace groundgrid {
namespace {

constexpr int kPasses = 3;
// Cells further below the surface than this are reflections: they lose weight too.
constexpr float kReflection_m = 0.5F;
// Raised cells belong together where they are at most so far apart, in cells, and so steep.
constexpr int kPatchReach = 2;
constexpr float kPatchSlope = 0.4F;
constexpr float kPatchStep_m = 0.02F;
// By so much the variance of a height is greater than that of its plane: measured on simulated
// drives.
constexpr float kPlaneFactor = 1.2F;

}  // namespace

SurfaceFit::SurfaceFit(int size, double cell_size_m)
    : size_(size),
      cell_size_(static_cast<float>(cell_size_m)),
      planes_(size, cell_size_m),
      weights_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
      heights_(weights_.size()),
      surface_(weights_.size()),
      standing_(weights_.size()) {
  told_.reserve(weights_.size());
  patch_.reserve(weights_.size());
}

void SurfaceFit::clear() {
  told_.clear();
  std::fill(weights_.begin(), weights_.end(), 0.0F);
  std::fill(standing_.begin(), standing_.end(), Standing::unknown);
}

void SurfaceFit::add(std::uint32_t cell, float height) {
  told_.push_back(cell);
  weights_[cell] = 1.0F;
  heights_[cell] = height;
  standing_[cell] = Standing::on_surface;
}

void SurfaceFit::reweight(const Config& config) {
  const auto tolerance = static_cast<float>(config.surface_tolerance_m);
  for (const std::uint32_t cell : told_) {
    const float above = heights_[cell] - surface_[cell];
    float ratio = 1.0F;
    if (above > tolerance) ratio = tolerance / above;
    if (above < -kReflection_m) ratio = -kReflection_m / above;
    weights_[cell] = ratio * ratio;
  }
}

void SurfaceFit::find_raised(const Config& config) {
  const auto step = static_cast<float>(config.surface_step_m);
  for (const std::uint32_t cell : told_)
    standing_[cell] =
        heights_[cell] > surface_[cell] + step ? Standing::raised : Standing::on_surface;
}

/// Collects the raised cells that hang together with this one.
void SurfaceFit::follow_raised(std::uint32_t seed) {
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
void SurfaceFit::keep_plateaus(const Config& config) {
  const auto cells = static_cast<std::size_t>(
      config.plateau_area_m2 / (static_cast<double>(cell_size_) * static_cast<double>(cell_size_)));
  const auto highest = static_cast<float>(config.plateau_height_m);
  for (const std::uint32_t seed : told_) {
    if (standing_[seed] != Standing::raised) continue;
    follow_raised(seed);
    float sum = 0.0F;
    for (const std::uint32_t cell : patch_) sum += heights_[cell] - surface_[cell];
    const bool plateau = patch_.size() > cells && sum < highest * static_cast<float>(patch_.size());
    if (!plateau) continue;
    for (const std::uint32_t cell : patch_) standing_[cell] = Standing::on_surface;
  }
}

void SurfaceFit::reject_raised(const LocalPlane& top, const Config& config) {
  const std::size_t level = planes_.level_of(config.surface_block_m);
  for (int pass = 0; pass < kPasses; ++pass) {
    planes_.fit(weights_, heights_, top, level);
    planes_.evaluate(level, surface_);
    reweight(config);
  }
  find_raised(config);
  keep_plateaus(config);
}

void SurfaceFit::fit(std::span<const float> heights, const LocalPlane& top) {
  for (std::size_t cell = 0; cell < weights_.size(); ++cell)
    weights_[cell] = standing_[cell] == Standing::on_surface ? 1.0F : 0.0F;
  planes_.fit(weights_, heights, top, 0);
  planes_.evaluate(0, surface_);
}

void SurfaceFit::standard_deviation(std::span<const float> heights, const Config& config,
                                    std::span<float> deviation) {
  planes_.evaluate_variance(0, deviation);
  planes_.evaluate(planes_.level_of(config.surface_block_m), heights_);
  for (std::size_t cell = 0; cell < deviation.size(); ++cell) {
    const float off = heights[cell] - surface_[cell];
    float variance = kPlaneFactor * deviation[cell] + off * off;
    if (standing_[cell] != Standing::on_surface) {
      const float off_wide = heights[cell] - heights_[cell];
      variance += off_wide * off_wide;
    }
    deviation[cell] = std::sqrt(variance);
  }
}

}  // namespace groundgrid
