// The sweeps of the ground envelope, compiled for each instruction set.
#include "core/envelope_kernels.hpp"

#include <algorithm>
#include <limits>

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/envelope_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "core/whole_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void SpreadAcross(const std::int32_t* HWY_RESTRICT from, std::int32_t* HWY_RESTRICT row,
                  std::size_t count, const EnvelopeRise& rise) {
  const hn::ScalableTag<std::int32_t> d;
  const auto straight = hn::Set(d, rise.straight);
  const auto diagonal = hn::Set(d, rise.diagonal);
  const std::size_t last = count - 1;
  // A lone column has nothing beside it.
  const auto spread_to = [&](std::size_t x, std::int32_t beside) {
    row[x] = std::min({row[x], from[x] + rise.straight, beside + rise.diagonal});
  };
  if (count == 1) return spread_to(0, from[0]);
  spread_to(0, from[1]);
  std::size_t x = 1;
  for (; x + hn::Lanes(d) <= last; x += hn::Lanes(d)) {
    const auto beside = hn::Min(hn::LoadU(d, from + x - 1), hn::LoadU(d, from + x + 1));
    const auto before = hn::Add(hn::LoadU(d, from + x), straight);
    const auto least = hn::Min(before, hn::Add(beside, diagonal));
    hn::StoreU(hn::Min(hn::LoadU(d, row + x), least), d, row + x);
  }
  for (; x < last; ++x) spread_to(x, std::min(from[x - 1], from[x + 1]));
  spread_to(last, from[last - 1]);
}

/// Lets heights rise along a row: first within each vector, by one, two, four, ... cells, then from
/// the last cell of the vector before. From the last cell to the first where backward.
template <bool kBackward, class D>
void SpreadAlong(D d, std::int32_t* row, std::size_t count, std::int32_t rise) {
  const std::size_t lanes = hn::Lanes(d);
  const auto lane = hn::Iota(d, 0);
  const auto none = hn::Set(d, kNoEnvelope);
  const auto from_before = hn::Mul(hn::Add(lane, hn::Set(d, 1)), hn::Set(d, rise));
  const auto last = hn::IndicesFromVec(d, hn::Set(d, static_cast<std::int32_t>(lanes) - 1));
  const auto turned = [](auto cells) HWY_ATTR {
    if constexpr (kBackward) return hn::Reverse(D(), cells);
    return cells;
  };
  const auto cells_at = [&](std::size_t x) { return row + (kBackward ? count - lanes - x : x); };
  const auto sweep = [&](std::size_t x, auto before) HWY_ATTR {
    auto cells = turned(hn::LoadU(d, cells_at(x)));
    for (std::size_t by = 1; by < lanes; by *= 2) {
      const auto cells_away = static_cast<std::int32_t>(by);
      const auto from = hn::Sub(lane, hn::Set(d, cells_away));
      const auto inside = hn::Not(hn::Lt(from, hn::Zero(d)));
      const auto moved =
          hn::TableLookupLanes(cells, hn::IndicesFromVec(d, hn::IfThenElseZero(inside, from)));
      const auto risen =
          hn::Add(hn::IfThenElse(inside, moved, none), hn::Set(d, cells_away * rise));
      cells = hn::Min(cells, risen);
    }
    cells = hn::Min(cells, hn::Add(before, from_before));
    hn::StoreU(turned(cells), d, cells_at(x));
    return hn::TableLookupLanes(cells, last);
  };
  auto before = none;
  std::size_t x = 0;
  for (; x + lanes <= count; x += lanes) before = sweep(x, before);
  // The last vector overlaps the one before: to rise again changes nothing.
  if (x == count) return;
  x = count - lanes;
  sweep(x, hn::Set(d, kBackward ? row[lanes] : row[x - 1]));
}

template <bool kBackward>
void Spread(std::int32_t* row, std::size_t count, std::int32_t rise) {
  const hn::ScalableTag<std::int32_t> d;
  if (count < hn::Lanes(d))
    SpreadAlong<kBackward>(hn::CappedTag<std::int32_t, 1>(), row, count, rise);
  else
    SpreadAlong<kBackward>(d, row, count, rise);
}

void SpreadForward(std::int32_t* row, std::size_t count, std::int32_t rise) {
  Spread<false>(row, count, rise);
}

void SpreadBackward(std::int32_t* row, std::size_t count, std::int32_t rise) {
  Spread<true>(row, count, rise);
}

/// The medians of nine numbers each, those that are NaN left out.
template <class D>
HWY_INLINE void MediansOfNine(D d, const MedianRows& rows, std::size_t i, float* medians,
                              float* weights) {
  const auto infinity = hn::Set(d, std::numeric_limits<float>::infinity());
  const auto one = hn::Set(d, 1.0F);
  auto count = hn::Zero(d);
  const auto take = [&](const float* row, std::size_t column) HWY_ATTR {
    const auto median = hn::LoadU(d, row + column);
    const auto missing = hn::IsNaN(median);
    count = hn::Add(count, hn::IfThenZeroElse(missing, one));
    return hn::IfThenElse(missing, infinity, median);
  };
  auto a = take(rows.below, i), b = take(rows.below, i + 1), c = take(rows.below, i + 2);
  auto e = take(rows.own, i), f = take(rows.own, i + 1), g = take(rows.own, i + 2);
  auto p = take(rows.above, i), q = take(rows.above, i + 1), r = take(rows.above, i + 2);
  const auto order = [](auto& low, auto& high) HWY_ATTR {
    const auto least = hn::Min(low, high);
    high = hn::Max(low, high);
    low = least;
  };
  // Nine numbers are in order after these 25 exchanges (Knuth, Sorting and Searching, 5.3.4).
  order(a, e), order(b, q), order(c, g), order(f, r);
  order(a, q), order(c, f), order(e, r), order(g, p);
  order(a, c), order(b, e), order(f, g), order(q, r);
  order(b, f), order(e, p), order(g, q);
  order(a, b), order(c, f), order(e, g), order(p, r);
  order(c, e), order(f, g), order(p, q);
  order(b, c), order(e, f), order(g, p);
  // Of n numbers that are there, place n / 2 from 0 on.
  const auto at_least = [&](float n, auto there, auto otherwise) HWY_ATTR {
    return hn::IfThenElse(hn::Ge(count, hn::Set(d, n)), there, otherwise);
  };
  const auto median = at_least(8, f, at_least(6, e, at_least(4, c, at_least(2, b, a))));
  const auto known = hn::Gt(count, hn::Zero(d));
  hn::StoreU(hn::IfThenElseZero(known, median), d, medians + i);
  hn::StoreU(hn::IfThenElseZero(known, one), d, weights + i);
}

void MedianRow(const MedianRows& rows, std::size_t count, float* medians, float* weights) {
  ForWholeVectors(
      count, [&](auto d, std::size_t i) HWY_ATTR { MediansOfNine(d, rows, i, medians, weights); });
}

/// How many come before a value, and how many are not after it: for the few that are asked for here
/// comparing all with all costs less than the jumps of a search.
float Ranked(const float* HWY_RESTRICT values, std::size_t count, std::size_t rank) {
  const hn::ScalableTag<float> d;
  for (std::size_t candidate = 0; candidate + 1 < count; ++candidate) {
    const auto value = hn::Set(d, values[candidate]);
    std::size_t before = 0;
    std::size_t not_after = 0;
    for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
      const auto others = hn::LoadU(d, values + i);
      const auto valid = hn::FirstN(d, count - i);
      before += hn::CountTrue(d, hn::And(hn::Lt(others, value), valid));
      not_after += hn::CountTrue(d, hn::And(hn::Le(others, value), valid));
    }
    if (before <= rank && rank < not_after) return values[candidate];
  }
  return values[count - 1];
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {

HWY_EXPORT(SpreadAcross);
HWY_EXPORT(SpreadForward);
HWY_EXPORT(SpreadBackward);
HWY_EXPORT(MedianRow);
HWY_EXPORT(Ranked);

void spread_across(const std::int32_t* from, std::int32_t* row, std::size_t count,
                   const EnvelopeRise& rise) {
  HWY_DYNAMIC_DISPATCH(SpreadAcross)(from, row, count, rise);
}

void spread_forward(std::int32_t* row, std::size_t count, std::int32_t rise) {
  HWY_DYNAMIC_DISPATCH(SpreadForward)(row, count, rise);
}

void spread_backward(std::int32_t* row, std::size_t count, std::int32_t rise) {
  HWY_DYNAMIC_DISPATCH(SpreadBackward)(row, count, rise);
}

void median_row(const MedianRows& rows, std::size_t count, float* medians, float* weights) {
  HWY_DYNAMIC_DISPATCH(MedianRow)(rows, count, medians, weights);
}

float ranked(const float* values, std::size_t count, std::size_t rank) {
  return HWY_DYNAMIC_DISPATCH(Ranked)(values, count, rank);
}

}  // namespace groundgrid
#endif
