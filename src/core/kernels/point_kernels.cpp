// The loops over points, compiled for each instruction set.
#include "core/kernels/point_kernels.hpp"

#include <algorithm>
#include <limits>

#include "core/stages/rasterization.hpp"

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/point_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

using Floats = hn::ScalableTag<float>;
using Ints = hn::RebindToSigned<Floats>;
using Words = hn::RebindToUnsigned<Floats>;

/// Bins as many points as load(index, x, y, z) gives, vector by vector.
template <class Load>
HWY_INLINE void BinVectors(std::size_t count, const BinRule& rule, const Load& load,
                           std::uint32_t* HWY_RESTRICT cells, std::int32_t* HWY_RESTRICT heights) {
  const Floats d;
  const Ints di;
  // A copy of its own stays in registers.
  const PointTransform own = rule.transform;
  const auto zero = hn::Zero(d);
  const auto nearest = hn::Set(d, rule.min_range_squared);
  const auto extent = hn::Set(d, rule.extent_m);
  const auto limit = hn::Set(d, rule.height_limit_m);
  const auto per_metre = hn::Set(d, BinnedPoints::kStepsPerMetre);
  const auto inverse = hn::Set(d, rule.inverse_cell_size);
  const auto last = hn::Set(di, rule.size - 1);
  const auto size = hn::Set(di, rule.size);
  for (std::size_t i = 0; i < count; i += hn::Lanes(d)) {
    hn::Vec<Floats> in_x, in_y, in_z;
    load(i, in_x, in_y, in_z);
    const auto moved = [&](const float* r, float t) HWY_ATTR {
      const auto along_xy =
          hn::Add(hn::Mul(hn::Set(d, r[0]), in_x), hn::Mul(hn::Set(d, r[1]), in_y));
      return hn::Add(hn::Add(along_xy, hn::Mul(hn::Set(d, r[2]), in_z)), hn::Set(d, t));
    };
    const auto x = moved(own.r, own.t[0]);
    const auto y = moved(own.r + 3, own.t[1]);
    const auto z = moved(own.r + 6, own.t[2]);
    const auto range_squared =
        hn::Add(hn::Add(hn::Mul(in_x, in_x), hn::Mul(in_y, in_y)), hn::Mul(in_z, in_z));
    // NaN compares false: it is outside.
    const auto inside_x = hn::And(hn::Ge(x, zero), hn::Lt(x, extent));
    const auto inside_y = hn::And(hn::Ge(y, zero), hn::Lt(y, extent));
    const auto taken = hn::And(hn::Lt(hn::Abs(z), limit), hn::Ge(range_squared, nearest));
    const auto inside = hn::And(hn::And(inside_x, inside_y), taken);
    const auto index_of = [&](auto metres) HWY_ATTR {
      const auto in_cells = hn::Mul(hn::IfThenElseZero(inside, metres), inverse);
      return hn::Min(hn::ConvertTo(di, in_cells), last);
    };
    const auto in_window = hn::Add(hn::Mul(index_of(y), size), index_of(x));
    const auto cell = hn::IfThenElse(hn::RebindMask(di, inside), in_window, hn::Set(di, -1));
    const auto steps = hn::NearestInt(hn::Mul(hn::IfThenElseZero(inside, z), per_metre));
    hn::StoreU(hn::BitCast(Words(), cell), Words(), cells + i);
    hn::StoreU(steps, di, heights + i);
  }
}

void BinBlockOf(const PointBlock& points, const BinRule& rule, BinBlock& bins) {
  const auto load = [&](std::size_t i, auto& x, auto& y, auto& z) HWY_ATTR {
    x = hn::Load(Floats(), points.x + i);
    y = hn::Load(Floats(), points.y + i);
    z = hn::Load(Floats(), points.z + i);
  };
  BinVectors(PointBlock::kMost, rule, load, bins.cell, bins.z);
}

void BinRecords(const PackedRecords& records, const BinRule& rule, std::uint32_t* cells,
                std::int32_t* heights) {
  const float* data = records.data;
  const auto load3 = [=](std::size_t i, auto& x, auto& y, auto& z)
                         HWY_ATTR { hn::LoadInterleaved3(Floats(), data + 3 * i, x, y, z); };
  const auto load4 = [=](std::size_t i, auto& x, auto& y, auto& z) HWY_ATTR {
    hn::Vec<Floats> ignored;
    hn::LoadInterleaved4(Floats(), data + 4 * i, x, y, z, ignored);
  };
  if (records.floats == 3)
    BinVectors(records.count, rule, load3, cells, heights);
  else
    BinVectors(records.count, rule, load4, cells, heights);
}

/// Vectors over points: calls visit(vector of cells, vector of heights, index, lanes) with lanes
/// that are no point, after the last one, set to no cell.
template <class Visit>
HWY_INLINE void ForPoints(const BinnedRange& points, const Visit& visit) {
  const std::uint32_t* cells = points.cells;
  const std::int32_t* z = points.z;
  const std::size_t count = points.count;
  const Words dw;
  const Ints di;
  const std::size_t lanes = hn::Lanes(di);
  std::size_t i = 0;
  for (; i + lanes <= count; i += lanes)
    visit(hn::BitCast(di, hn::LoadU(dw, cells + i)), hn::LoadU(di, z + i), i, lanes);
  if (i == count) return;
  HWY_ALIGN std::uint32_t last_cells[HWY_MAX_BYTES / sizeof(float)];
  HWY_ALIGN std::int32_t last_z[HWY_MAX_BYTES / sizeof(float)] = {};
  std::fill(last_cells, last_cells + lanes, BinnedPoints::kNoCell);
  std::copy(cells + i, cells + count, last_cells);
  std::copy(z + i, z + count, last_z);
  visit(hn::BitCast(di, hn::Load(dw, last_cells)), hn::Load(di, last_z), i, count - i);
}

/// Writes those of the mask one after the other, a whole vector in all; returns how many. (Some
/// processors take a hundred cycles to write only as many as there are.)
template <class V, class M, class D>
HWY_INLINE std::size_t Append(V values, M mask, D d, hn::TFromD<D>* to) {
  hn::StoreU(hn::Compress(values, mask), d, to);
  return hn::CountTrue(d, mask);
}

/// add_point() with vectors.
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void AddPoint(CellStatistics& cell, std::int32_t z) { add_point(z, cell); }
#else
HWY_INLINE void AddPoint(CellStatistics& cell, std::int32_t z) {
  const hn::FixedTag<std::int64_t, 2> sums;
  const hn::FixedTag<std::int32_t, 4> bounds;
  const std::int64_t height = z;
  auto* sum = &cell.sum;
  auto* min = &cell.min;
  const auto added =
      hn::InterleaveLower(sums, hn::Set(sums, height), hn::Set(sums, height * height));
  hn::Store(hn::Add(hn::Load(sums, sum), added), sums, sum);
  const auto all = hn::Set(bounds, z);
  const auto known = hn::Load(bounds, min);
  // Minimum and maximum are the first two of four numbers, the count is the third.
  const auto seen = hn::OddEven(hn::Max(known, all), hn::Min(known, all));
  const auto counted = hn::Add(known, hn::Set(bounds, 1));
  hn::Store(hn::ConcatUpperLower(bounds, counted, seen), bounds, min);
}
#endif

void AddPoints(const BinnedRange& points, CellBand band, CellStatistics* HWY_RESTRICT statistics,
               std::uint8_t* HWY_RESTRICT is_occupied) {
  constexpr std::size_t kParts = 8;
  const std::uint32_t* HWY_RESTRICT cells = points.cells;
  const std::int32_t* HWY_RESTRICT z = points.z;
  const std::uint32_t length = band.end - band.begin;
  const auto take = [&](std::size_t i) HWY_ATTR {
    const std::uint32_t cell = cells[i];
    if (cell - band.begin >= length) return;
    AddPoint(statistics[cell], z[i]);
    is_occupied[cell] = 1;
  };
  // Points from eight parts take turns: those beside each other often fall into one cell, and each
  // would wait for the one before it to be written.
  const std::size_t part = points.count / kParts;
  for (std::size_t i = 0; i < part; ++i)
    for (std::size_t p = 0; p < kParts; ++p) take(p * part + i);
  for (std::size_t i = kParts * part; i < points.count; ++i) take(i);
}

std::size_t FindDeep(const BinnedRange& points, const DepthRule& rule, std::uint32_t* found) {
  const Floats d;
  const Ints di;
  const Words dw;
  const auto step = hn::Set(d, static_cast<float>(CellStatistics::kStep_m));
  const auto min_depth = hn::Set(d, rule.min_depth_m);
  const auto index = hn::Iota(di, 0);
  std::size_t number = 0;
  ForPoints(points, [&](auto cell, auto height, std::size_t i, std::size_t) HWY_ATTR {
    const auto in_cell = hn::Gt(cell, hn::Set(di, -1));
    const auto of_cell = hn::GatherIndex(d, rule.heights, hn::IfThenElseZero(in_cell, cell));
    const auto depth = hn::Sub(of_cell, hn::Mul(hn::ConvertTo(d, height), step));
    const auto deep = hn::And(hn::RebindMask(d, in_cell), hn::Ge(depth, min_depth));
    if (hn::AllFalse(d, deep)) return;
    const auto at = hn::Add(index, hn::Set(di, static_cast<std::int32_t>(i)));
    number += Append(hn::BitCast(dw, at), hn::RebindMask(dw, deep), dw, found + number);
  });
  return number;
}

std::size_t SelectColumns(const BinnedRange& points, const ColumnRule& rule,
                          std::uint32_t* found_cells, std::int32_t* found_above) {
  const Ints di;
  const Words dw;
  const auto begin = hn::Set(di, static_cast<std::int32_t>(rule.band.begin));
  const auto end = hn::Set(di, static_cast<std::int32_t>(rule.band.end));
  const auto below = hn::Set(di, -rule.band_below);
  const auto above = hn::Set(di, rule.band_above);
  const auto tall = hn::Set(di, rule.tall);
  const auto overhang = hn::Set(di, rule.overhang);
  std::size_t number = 0;
  ForPoints(points, [&](auto cell, auto height, std::size_t, std::size_t) HWY_ATTR {
    const auto counts = hn::And(hn::Not(hn::Lt(cell, begin)), hn::Lt(cell, end));
    const auto of_cell = hn::GatherIndex(di, rule.heights, hn::IfThenElse(counts, cell, begin));
    const auto up = hn::Sub(height, of_cell);
    const auto near = hn::And(hn::Gt(up, below), hn::Lt(up, above));
    const auto rising = hn::And(hn::Gt(up, tall), hn::Lt(up, overhang));
    const auto taken = hn::And(counts, hn::Or(near, rising));
    if (hn::AllFalse(di, taken)) return;
    Append(hn::BitCast(dw, cell), hn::RebindMask(dw, taken), dw, found_cells + number);
    number += Append(up, taken, di, found_above + number);
  });
  return number;
}

/// Levels and thresholds of cells, a pair at once where a vector holds more than one number.
#if HWY_TARGET == HWY_SCALAR
HWY_INLINE void GatherLimits(const float* limits, hn::Vec<Ints> cells, hn::Vec<Floats>& levels,
                             hn::Vec<Floats>& thresholds) {
  const auto first = hn::ShiftLeft<1>(cells);
  levels = hn::GatherIndex(Floats(), limits, first);
  thresholds = hn::GatherIndex(Floats(), limits + 1, first);
}
#else
HWY_INLINE void GatherLimits(const float* limits, hn::Vec<Ints> cells, hn::Vec<Floats>& levels,
                             hn::Vec<Floats>& thresholds) {
  const Floats d;
  const hn::RepartitionToWide<Ints> pairs;
  const auto* pair_of = reinterpret_cast<const std::int64_t*>(limits);
  const auto gather = [&](auto half) HWY_ATTR {
    return hn::BitCast(d, hn::GatherIndex(pairs, pair_of, hn::PromoteTo(pairs, half)));
  };
  const auto lower = gather(hn::LowerHalf(hn::Half<Ints>(), cells));
  const auto upper = gather(hn::UpperHalf(hn::Half<Ints>(), cells));
  levels = hn::ConcatEven(d, upper, lower);
  thresholds = hn::ConcatOdd(d, upper, lower);
}
#endif

LabelCounts LabelPoints(const BinnedRange& points, const float* limits, Label* labels,
                        float* height_above_ground, std::uint32_t* outliers) {
  const Floats d;
  const Ints di;
  const Words dw;
  const hn::Rebind<std::uint8_t, Ints> bytes;
  const auto step = hn::Set(d, static_cast<float>(CellStatistics::kStep_m));
  const auto nan = hn::Set(d, std::numeric_limits<float>::quiet_NaN());
  const auto ground_label = hn::Set(di, static_cast<std::int32_t>(Label::ground));
  const auto obstacle_label = hn::Set(di, static_cast<std::int32_t>(Label::obstacle));
  const auto none = hn::Set(di, -1);
  const auto index = hn::Iota(di, 0);
  LabelCounts counts;
  std::size_t answered = 0;
  ForPoints(points, [&](auto cell, auto height, std::size_t i, std::size_t lanes) HWY_ATTR {
    const auto in_cell = hn::Gt(cell, hn::Set(di, -1));
    hn::Vec<Floats> level, threshold;
    GatherLimits(limits, hn::IfThenElseZero(in_cell, cell), level, threshold);
    const auto above = hn::Sub(hn::Mul(hn::ConvertTo(d, height), step), level);
    const auto ground = hn::And(hn::Le(above, threshold), hn::RebindMask(d, in_cell));
    const auto label = hn::IfThenElseZero(
        in_cell, hn::IfThenElse(hn::RebindMask(di, ground), ground_label, obstacle_label));
    const auto answer = hn::IfThenElse(hn::RebindMask(d, in_cell), above, nan);
    counts.ground += hn::CountTrue(d, ground);
    answered += hn::CountTrue(di, in_cell);
    const auto marked = hn::Lt(cell, none);
    if (!hn::AllFalse(di, marked)) {
      const auto at = hn::Add(index, hn::Set(di, static_cast<std::int32_t>(i)));
      counts.outlier +=
          Append(hn::BitCast(dw, at), hn::RebindMask(dw, marked), dw, outliers + counts.outlier);
    }
    if (lanes == hn::Lanes(d)) {
      hn::StoreU(answer, d, height_above_ground + i);
      hn::StoreU(hn::DemoteTo(bytes, label), bytes, reinterpret_cast<std::uint8_t*>(labels + i));
      return;
    }
    HWY_ALIGN float last_answers[HWY_MAX_BYTES / sizeof(float)];
    HWY_ALIGN std::uint8_t last_labels[HWY_MAX_BYTES / sizeof(float)];
    hn::StoreU(answer, d, last_answers);
    hn::StoreU(hn::DemoteTo(bytes, label), bytes, last_labels);
    for (std::size_t lane = 0; lane < lanes; ++lane) {
      height_above_ground[i + lane] = last_answers[lane];
      labels[i + lane] = static_cast<Label>(last_labels[lane]);
    }
  });
  counts.obstacle = answered - counts.ground;
  counts.unknown = points.count - answered - counts.outlier;
  return counts;
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {
namespace {

HWY_EXPORT(BinBlockOf);
HWY_EXPORT(BinRecords);
HWY_EXPORT(AddPoints);
HWY_EXPORT(FindDeep);
HWY_EXPORT(SelectColumns);
HWY_EXPORT(LabelPoints);

}  // namespace

void bin_block(const PointBlock& points, const BinRule& rule, BinBlock& bins) {
  HWY_DYNAMIC_DISPATCH(BinBlockOf)(points, rule, bins);
}

void bin_records(const PackedRecords& records, const BinRule& rule, std::uint32_t* cells,
                 std::int32_t* z) {
  HWY_DYNAMIC_DISPATCH(BinRecords)(records, rule, cells, z);
}

void add_points(const BinnedRange& points, CellBand band, CellStatistics* statistics,
                std::uint8_t* is_occupied) {
  HWY_DYNAMIC_DISPATCH(AddPoints)(points, band, statistics, is_occupied);
}

std::size_t find_deep(const BinnedRange& points, const DepthRule& rule, std::uint32_t* found) {
  return HWY_DYNAMIC_DISPATCH(FindDeep)(points, rule, found);
}

std::size_t select_columns(const BinnedRange& points, const ColumnRule& rule,
                           std::uint32_t* found_cells, std::int32_t* found_above) {
  return HWY_DYNAMIC_DISPATCH(SelectColumns)(points, rule, found_cells, found_above);
}

LabelCounts label_points(const BinnedRange& points, const float* limits, Label* labels,
                         float* height_above_ground, std::uint32_t* outliers) {
  return HWY_DYNAMIC_DISPATCH(LabelPoints)(points, limits, labels, height_above_ground, outliers);
}

}  // namespace groundgrid
#endif
