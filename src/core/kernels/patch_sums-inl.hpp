// Sums over the patches of cells, for one instruction set: included once for each of them.
#if defined(GROUNDGRID_PATCH_SUMS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GROUNDGRID_PATCH_SUMS_INL
#undef GROUNDGRID_PATCH_SUMS_INL
#else
#define GROUNDGRID_PATCH_SUMS_INL
#endif

#include <hwy/highway.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>

#include "core/kernels/ground_cell_kernels.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Whether vectors have a length that is known here and can be handed about.
#undef GROUNDGRID_FIXED_VECTORS
#define GROUNDGRID_FIXED_VECTORS \
  (HWY_TARGET != HWY_SCALAR &&   \
   (HWY_TARGET & (HWY_RVV | HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128)) == 0)

// Sums over columns of cells. Which are added to which first is the same for every length of
// vector.
#if !GROUNDGRID_FIXED_VECTORS
using CellSum = WeightedCell;

HWY_INLINE CellSum LoadCell(const WeightedCell& cell) { return cell; }
HWY_INLINE CellSum Plus(const CellSum& a, const CellSum& b) {
  return {a.points + b.points, a.min_height + b.min_height, a.variance + b.variance, 0.0F};
}
HWY_INLINE WeightedCell Total(const CellSum& sum) { return sum; }
#else
constexpr std::size_t kNumbers = sizeof(WeightedCell) / sizeof(float);
using CellTag = hn::FixedTag<float, kNumbers>;
using CellSum = hn::Vec<CellTag>;

HWY_INLINE CellSum LoadCell(const WeightedCell& cell) { return hn::LoadU(CellTag(), &cell.points); }
HWY_INLINE CellSum Plus(CellSum a, CellSum b) { return hn::Add(a, b); }
HWY_INLINE WeightedCell Total(CellSum sum) {
  WeightedCell total;
  hn::StoreU(sum, CellTag(), &total.points);
  return total;
}
#endif

/// Rows of cells, one above the other.
struct PatchRows {
  const WeightedCell* HWY_RESTRICT first;
  std::ptrdiff_t stride;
};

template <int kRows>
HWY_INLINE CellSum SumColumn(const PatchRows& rows, std::ptrdiff_t column) {
  CellSum sum = LoadCell(rows.first[column]);
  for (int y = 1; y < kRows; ++y) sum = Plus(sum, LoadCell(rows.first[y * rows.stride + column]));
  return sum;
}

#if !GROUNDGRID_FIXED_VECTORS || HWY_MAX_BYTES == 16
/// Columns 0 and 1.
template <int kRows>
HWY_INLINE CellSum SumTwoColumns(const PatchRows& rows) {
  return Plus(SumColumn<kRows>(rows, 0), SumColumn<kRows>(rows, 1));
}

/// Columns 0 and 2, and 1 and 3.
template <int kRows>
HWY_INLINE CellSum SumFourColumns(const PatchRows& rows) {
  return Plus(Plus(SumColumn<kRows>(rows, 0), SumColumn<kRows>(rows, 2)),
              Plus(SumColumn<kRows>(rows, 1), SumColumn<kRows>(rows, 3)));
}
#else
/// As many columns as a vector holds, each for itself.
template <int kRows, class D>
HWY_INLINE hn::Vec<D> SumColumns(D d, const PatchRows& rows, std::ptrdiff_t column) {
  auto sum = hn::LoadU(d, &rows.first[column].points);
  for (int y = 1; y < kRows; ++y)
    sum = hn::Add(sum, hn::LoadU(d, &rows.first[y * rows.stride + column].points));
  return sum;
}

template <class D>
HWY_INLINE hn::Vec<hn::Half<D>> AddHalves(D d, hn::Vec<D> sum) {
  return hn::Add(hn::LowerHalf(hn::Half<D>(), sum), hn::UpperHalf(hn::Half<D>(), sum));
}

template <int kRows>
HWY_INLINE CellSum SumTwoColumns(const PatchRows& rows) {
  const hn::FixedTag<float, 2 * kNumbers> two;
  return AddHalves(two, SumColumns<kRows>(two, rows, 0));
}

template <int kRows>
HWY_INLINE CellSum SumFourColumns(const PatchRows& rows) {
  const hn::FixedTag<float, 2 * kNumbers> two;
#if HWY_MAX_BYTES >= 64
  const hn::FixedTag<float, 4 * kNumbers> four;
  return AddHalves(two, AddHalves(four, SumColumns<kRows>(four, rows, 0)));
#else
  return AddHalves(two, hn::Add(SumColumns<kRows>(two, rows, 0), SumColumns<kRows>(two, rows, 2)));
#endif
}
#endif

/// Sums over the cells up to one or two away in both directions, all of them in the window.
HWY_INLINE WeightedCell SumNine(const PatchRows& rows) {
  return Total(Plus(SumTwoColumns<3>(rows), SumColumn<3>(rows, 2)));
}
HWY_INLINE WeightedCell SumTwentyFive(const PatchRows& rows) {
  return Total(Plus(SumFourColumns<5>(rows), SumColumn<5>(rows, 4)));
}

/// The same at the border: cells outside the window add nothing.
WeightedCell SumAtBorder(const ClassRule& rule, int column, int row, int half) {
  const auto column_sum = [&](int x) HWY_ATTR {
    CellSum sum = LoadCell(WeightedCell{});
    if (column + x < 0 || column + x >= rule.size) return sum;
    for (int y = std::max(row - half, 0); y <= std::min(row + half, rule.size - 1); ++y)
      sum = Plus(sum, LoadCell(rule.cells[std::ptrdiff_t{y} * rule.size + column + x]));
    return sum;
  };
  if (half == 1) return Total(Plus(Plus(column_sum(-1), column_sum(0)), column_sum(1)));
  return Total(Plus(Plus(Plus(column_sum(-2), column_sum(0)), Plus(column_sum(-1), column_sum(1))),
                    column_sum(2)));
}

HWY_INLINE WeightedCell SumPatch(const ClassRule& rule, std::uint32_t cell, int column, int row,
                                 int half) {
  if (column < half || row < half || column + half >= rule.size || row + half >= rule.size)
    return SumAtBorder(rule, column, row, half);
  const WeightedCell* own = rule.cells + cell;
  return half == 1 ? SumNine({own - rule.size - 1, rule.size})
                   : SumTwentyFive({own - 2 * std::ptrdiff_t{rule.size} - 2, rule.size});
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
