// The loops over the cells around each cell, compiled for each instruction set.
#include "core/kernels/offset_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>

#include "core/method/constants.hpp"

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/offset_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "core/kernels/whole_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

// So many cells of a row at once, where any of them is occupied.
constexpr std::size_t kCellsAtOnce = 128;
constexpr std::size_t kReach = OffsetGrid::kMargin;
using Sums = float[kCellsAtOnce + 2 * kReach + OffsetGrid::kSpare];

/// Sums over the rows around a row, of `count` cells and those beside them.
void SumRows(const float* HWY_RESTRICT own, std::size_t stride, std::size_t count,
             float* HWY_RESTRICT sums) {
  const hn::ScalableTag<float> d;
  for (std::size_t i = 0; i < count + 2 * kReach; i += hn::Lanes(d)) {
    const float* from = own - kReach * stride - kReach + i;
    auto sum = hn::LoadU(d, from);
    for (std::size_t y = 1; y <= 2 * kReach; ++y)
      sum = hn::Add(sum, hn::LoadU(d, from + y * stride));
    hn::StoreU(sum, d, sums + i);
  }
}

/// Then over the columns around a cell.
template <class D>
HWY_INLINE hn::Vec<D> SumAlong(D d, const float* HWY_RESTRICT sums) {
  auto sum = hn::LoadU(d, sums);
  for (std::size_t x = 1; x <= 2 * kReach; ++x) sum = hn::Add(sum, hn::LoadU(d, sums + x));
  return sum;
}

/// One vector of cells; weights and weighted steps of their own, and sums over rows of both.
template <class D>
HWY_INLINE void RaiseVector(D d, const float* weights, const float* weighted,
                            const float* sum_weights, const float* sum_weighted, float step_m,
                            const LevelRow& cells) {
  const hn::Rebind<std::uint8_t, D> bytes;
  const auto occupied = hn::LoadU(bytes, cells.is_occupied);
  if (hn::AllTrue(bytes, hn::Eq(occupied, hn::Zero(bytes)))) return;
  const auto no_offset = hn::Set(d, constants::kNoOffsetPoints);
  const auto own_more = hn::Set(d, constants::kOwnWeight - 1.0F);
  const auto steps = hn::Add(hn::Mul(own_more, hn::LoadU(d, weighted)), SumAlong(d, sum_weighted));
  const auto points = hn::Add(hn::Add(no_offset, hn::Mul(own_more, hn::LoadU(d, weights))),
                              SumAlong(d, sum_weights));
  const auto raised =
      hn::Add(hn::LoadU(d, cells.heights), hn::Mul(hn::Div(steps, points), hn::Set(d, step_m)));
  hn::Vec<D> level, threshold;
  hn::LoadInterleaved2(d, cells.limits, level, threshold);
  hn::StoreInterleaved2(raised, threshold, d, cells.limits);
}

void RaiseLevels(const OffsetGrid& grid, std::size_t row, float step_m, const LevelRow& cells) {
  const std::size_t stride = grid.size + kReach;
  HWY_ALIGN Sums sum_weights;
  HWY_ALIGN Sums sum_weighted;
  for (std::size_t first = 0; first < grid.size; first += kCellsAtOnce) {
    const std::size_t count = std::min(kCellsAtOnce, grid.size - first);
    if (std::memchr(cells.is_occupied + first, 1, count) == nullptr) continue;
    const std::size_t place = OffsetGrid::place(grid.size, row * grid.size + first, row);
    SumRows(grid.weights + place, stride, count, sum_weights);
    SumRows(grid.weighted_steps + place, stride, count, sum_weighted);
    ForWholeVectors(count, [&](auto d, std::size_t i) HWY_ATTR {
      RaiseVector(d, grid.weights + place + i, grid.weighted_steps + place + i, sum_weights + i,
                  sum_weighted + i, step_m,
                  {cells.is_occupied + first + i, cells.heights + first + i,
                   cells.limits + 2 * (first + i)});
    });
  }
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {

HWY_EXPORT(RaiseLevels);

void raise_levels(const OffsetGrid& grid, std::size_t row, float step_m, const LevelRow& cells) {
  HWY_DYNAMIC_DISPATCH(RaiseLevels)(grid, row, step_m, cells);
}

}  // namespace groundgrid
#endif
