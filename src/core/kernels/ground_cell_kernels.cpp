// The loops over occupied cells, compiled for each instruction set.
#include "core/kernels/ground_cell_kernels.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/map/window_cells.hpp"
#include "core/method/constants.hpp"
#include "core/stages/ground_cells.hpp"

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/ground_cell_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "core/kernels/patch_sums-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void WeighCells(std::span<const std::uint32_t> occupied,
                const CellStatistics* HWY_RESTRICT statistics, WeightedCell* HWY_RESTRICT cells) {
  constexpr double kStep_m = CellStatistics::kStep_m;
  for (const std::uint32_t index : occupied) {
    const CellStatistics& cell = statistics[index];
    const double per_point = 1.0 / static_cast<double>(cell.count);
    const double mean = static_cast<double>(cell.sum) * per_point;
    const double spread = static_cast<double>(cell.sum_squares) * per_point - mean * mean;
    const auto variance = static_cast<float>(std::max(spread, 0.0) * (kStep_m * kStep_m));
    const auto points = static_cast<float>(cell.count);
    const float lowest = static_cast<float>(cell.min) * static_cast<float>(kStep_m);
    cells[index] = {points, points * lowest, points * variance, variance};
  }
}

/// From the minima of the cells beside this one; an axis without both of them adds nothing.
float SlopeSquared(const ClassRule& rule, int column, int row) {
  const auto at = [&](int x, int y) -> const WeightedCell& {
    return rule.cells[y * rule.size + x];
  };
  const auto slope = [&](const WeightedCell& before, const WeightedCell& own,
                         const WeightedCell& after) {
    if (!(before.points > 0.0F && after.points > 0.0F)) return 0.0F;
    return slope_along(before.min_height / before.points, own.min_height / own.points,
                       after.min_height / after.points, rule.cell_size);
  };
  const WeightedCell& own = at(column, row);
  float squared = 0.0F;
  if (column > 0 && column < rule.size - 1) {
    const float along_x = slope(at(column - 1, row), own, at(column + 1, row));
    squared += along_x * along_x;
  }
  if (row > 0 && row < rule.size - 1) {
    const float along_y = slope(at(column, row - 1), own, at(column, row + 1));
    squared += along_y * along_y;
  }
  return squared;
}

/// Some occupied cells, and what is worked out for all of them at once.
struct CellBlock {
  static constexpr std::size_t kMost = 64;
  std::span<const std::uint32_t> cells;
  HWY_ALIGN std::int32_t column[kMost] = {};
  HWY_ALIGN std::int32_t row[kMost] = {};
  HWY_ALIGN float distance_squared[kMost] = {};
  HWY_ALIGN WeightedCell own[kMost] = {};
  HWY_ALIGN WeightedCell patch[kMost] = {};
  HWY_ALIGN float elevation[kMost] = {};
  HWY_ALIGN float variance[kMost] = {};
  HWY_ALIGN std::int32_t smooth[kMost] = {};
  bool any_slope = false;  ///< Whether the slope decides about any of them.
};

using Floats = hn::CappedTag<float, CellBlock::kMost>;
using Ints = hn::RebindToSigned<Floats>;

/// To the nearest sensor.
void MeasureDistances(const ClassRule& rule, CellBlock& block) {
  const Floats d;
  const Ints di;
  const auto half = hn::Set(d, 0.5F);
  const auto cell_size = hn::Set(d, rule.cell_size);
  for (std::size_t i = 0; i < block.cells.size(); i += hn::Lanes(d)) {
    const auto metres = [&](const std::int32_t* index) HWY_ATTR {
      return hn::Mul(hn::Add(hn::ConvertTo(d, hn::Load(di, index + i)), half), cell_size);
    };
    const auto x = metres(block.column);
    const auto y = metres(block.row);
    auto nearest = hn::Set(d, std::numeric_limits<float>::infinity());
    for (const Point3f& sensor : rule.sensors) {
      const auto to_x = hn::Sub(x, hn::Set(d, sensor.x));
      const auto to_y = hn::Sub(y, hn::Set(d, sensor.y));
      nearest = hn::Min(nearest, hn::Add(hn::Mul(to_x, to_x), hn::Mul(to_y, to_y)));
    }
    hn::Store(nearest, d, block.distance_squared + i);
  }
}

void SumPatches(const ClassRule& rule, CellBlock& block) {
  constexpr float kWideFromSquared = constants::kWidePatchFrom_m * constants::kWidePatchFrom_m;
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    const int half = block.distance_squared[i] < kWideFromSquared ? 1 : 2;
    block.own[i] = rule.cells[block.cells[i]];
    block.patch[i] = SumPatch(rule, block.cells[i], block.column[i], block.row[i], half);
  }
}

/// All but the slopes.
void JudgeCells(const ClassRule& rule, CellBlock& block) {
  const Floats d;
  const Ints di;
  const auto threshold = hn::Set(d, constants::kMaxVariance_m2);
  const auto on_slopes = hn::Set(d, steepest_threshold(rule.cell_size));
  const auto own_points_enough = hn::Set(d, static_cast<float>(constants::kOwnVariancePoints));
  auto undecided = hn::Zero(di);
  for (std::size_t i = 0; i < block.cells.size(); i += hn::Lanes(d)) {
    hn::Vec<Floats> points, min_height, variance, own_points, own_variance, unused, unused_too;
    hn::LoadInterleaved4(d, &block.patch[i].points, points, min_height, variance, unused);
    hn::LoadInterleaved4(d, &block.own[i].points, own_points, unused, unused_too, own_variance);
    const auto tested = hn::IfThenElse(hn::Ge(own_points, own_points_enough), own_variance,
                                       hn::Div(variance, points));
    const auto flat = hn::Lt(tested, threshold);
    const auto slope_decides = hn::AndNot(flat, hn::Lt(tested, on_slopes));
    undecided = hn::Or(undecided, hn::VecFromMask(di, hn::RebindMask(di, slope_decides)));
    hn::Store(hn::Div(min_height, points), d, block.elevation + i);
    hn::Store(tested, d, block.variance + i);
    hn::Store(hn::VecFromMask(di, hn::RebindMask(di, flat)), di, block.smooth + i);
  }
  block.any_slope = !hn::AllFalse(di, hn::Ne(undecided, hn::Zero(di)));
}

/// A slope makes heights differ within a cell.
void JudgeSlopes(const ClassRule& rule, CellBlock& block) {
  for (std::size_t i = 0; i < block.cells.size(); ++i) {
    if (block.smooth[i] != 0 || !(block.variance[i] < steepest_threshold(rule.cell_size))) continue;
    const float slope_squared = SlopeSquared(rule, block.column[i], block.row[i]);
    block.smooth[i] =
        block.variance[i] < variance_threshold_on(slope_squared, rule.cell_size) ? 1 : 0;
  }
}

void ClassifyCells(std::span<const std::uint32_t> occupied, const ClassRule& rule,
                   GroundCell* HWY_RESTRICT answers, std::uint8_t* HWY_RESTRICT is_ground) {
  if (occupied.empty()) return;
  AscendingRows rows(static_cast<std::size_t>(rule.size), occupied.front());
  CellBlock block;
  for (std::size_t first = 0; first < occupied.size(); first += CellBlock::kMost) {
    block.cells = occupied.subspan(first, std::min(CellBlock::kMost, occupied.size() - first));
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const auto row = static_cast<std::int32_t>(rows.row_of(block.cells[i]));
      block.row[i] = row;
      block.column[i] = static_cast<std::int32_t>(block.cells[i]) - row * rule.size;
    }
    MeasureDistances(rule, block);
    SumPatches(rule, block);
    JudgeCells(rule, block);
    if (block.any_slope) JudgeSlopes(rule, block);
    for (std::size_t i = 0; i < block.cells.size(); ++i) {
      const bool supported = rule.supported[block.cells[i]] != 0;
      const bool smooth = block.smooth[i] != 0;
      const bool ground = supported && smooth;
      answers[first + i] = {
          block.patch[i].points, block.elevation[i], block.variance[i], supported, ground,
          smooth && !supported};
      is_ground[block.cells[i]] = ground ? 1 : 0;
    }
  }
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {

HWY_EXPORT(WeighCells);
HWY_EXPORT(ClassifyCells);

void weigh_cells(std::span<const std::uint32_t> occupied, const CellStatistics* statistics,
                 WeightedCell* cells) {
  HWY_DYNAMIC_DISPATCH(WeighCells)(occupied, statistics, cells);
}

void classify_cells(std::span<const std::uint32_t> occupied, const ClassRule& rule,
                    GroundCell* answers, std::uint8_t* is_ground) {
  HWY_DYNAMIC_DISPATCH(ClassifyCells)(occupied, rule, answers, is_ground);
}

}  // namespace groundgrid
#endif
