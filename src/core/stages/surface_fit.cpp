// The ground on the whole: what stands on it, what it is where nothing was seen, how far off it may
// be. Not in the paper.
#include "core/stages/surface_fit.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/kernels/marked_cells.hpp"
#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

using namespace constants;

}  // namespace

SurfaceFit::SurfaceFit(int size, double resolution_m, TileRunner& runner)
    : runner_(&runner),
      size_(size),
      cell_size_(static_cast<float>(resolution_m)),
      planes_(size, resolution_m, runner.threads()),
      heights_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)),
      surface_(heights_.size()),
      standing_(heights_.size()) {
  raised_.reserve(heights_.size());
  patch_.reserve(heights_.size());
}

void SurfaceFit::accept_all() {
  for (std::size_t cell = 0; cell < heights_.size(); ++cell)
    standing_[cell] = heights_[cell] == kUnknownHeight ? Standing::unknown : Standing::on_surface;
}

void SurfaceFit::list_raised() {
  raised_.clear();
  const auto* standing = reinterpret_cast<const std::uint8_t*>(standing_.data());
  append_marked({standing, standing_.size()}, static_cast<std::uint8_t>(Standing::raised), raised_);
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
void SurfaceFit::keep_terraces(double terrace_m2) {
  const auto wide = static_cast<std::size_t>(
      terrace_m2 / (static_cast<double>(cell_size_) * static_cast<double>(cell_size_)));
  for (const std::uint32_t seed : raised_) {
    if (standing_[seed] != Standing::raised) continue;
    follow_raised(seed);
    float sum = 0.0F;
    for (const std::uint32_t cell : patch_) sum += heights_[cell] - surface_[cell];
    const auto cells = static_cast<float>(patch_.size());
    const bool low = sum < kTerraceHeight_m * cells;
    if (patch_.size() <= wide || !low) continue;
    for (const std::uint32_t cell : patch_) standing_[cell] = Standing::on_surface;
  }
}

void SurfaceFit::reject_raised(const LocalPlane& top, double terrace_m2) {
  const std::size_t level = planes_.level_of(kSurfaceBlock_m);
  const auto count = static_cast<std::size_t>(size_);
  constexpr HeightTolerance tolerance{kSurfaceTolerance_m, kReflection_m};
  const auto heights_of = [&](std::size_t row) { return heights_.data() + row * count; };
  using RowCursor = PlaneHierarchy::RowCursor;
  const auto weigh = [&](std::size_t row, const RowCursor&, float* weights) {
    weigh_known(heights_of(row), count, weights);
  };
  const auto reweigh = [&](std::size_t row, RowCursor& cursor, float* weights) {
    const SurfaceBetween along = planes_.surface_along(level, row, cursor);
    reweight(heights_of(row), along, tolerance, count, weights);
  };
  planes_.fit(heights_, weigh, top, level, *runner_);
  for (int pass = 1; pass < kSurfacePasses; ++pass)
    planes_.fit(heights_, reweigh, top, level, *runner_);
  planes_.for_each_row(level, *runner_, [&](std::size_t row, const SurfaceBetween& along) {
    judge(heights_of(row), along, kSurfaceStep_m, count, standing_.data() + row * count,
          surface_.data() + row * count);
  });
  list_raised();
  keep_terraces(terrace_m2);
  std::erase_if(raised_, [&](std::uint32_t cell) { return !is_raised(cell); });
}

bool SurfaceFit::accept(std::uint32_t cell, float height) {
  const float surface = planes_.height_at(planes_.level_of(kSurfaceBlock_m), cell);
  const float above = height - surface;
  if (above > kSurfaceStep_m || above < -kReflection_m) return false;
  standing_[cell] = Standing::on_surface;
  return true;
}

void SurfaceFit::fit(std::span<const float> heights, const LocalPlane& top) {
  const auto count = static_cast<std::size_t>(size_);
  const auto weigh = [&](std::size_t row, const PlaneHierarchy::RowCursor&, float* weights) {
    weigh_surface(standing_.data() + row * count, count, weights);
  };
  planes_.fit(heights, weigh, top, 0, *runner_);
}

void SurfaceFit::standard_deviation(std::span<const float> heights, std::span<float> deviation) {
  planes_.evaluate_variance(0, deviation);
  planes_.evaluate(0, *runner_, surface_);
  planes_.evaluate(planes_.level_of(kSurfaceBlock_m), *runner_, heights_);
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
