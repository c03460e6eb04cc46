// The loops of the plane hierarchy, compiled for each instruction set.
#include "core/kernels/plane_kernels.hpp"

#include <algorithm>

#include "core/kernels/vector_loop.hpp"

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/plane_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "core/kernels/whole_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void AddRows(const CellRows& rows, std::size_t count, ColumnSums& sums) {
  const auto add = [&](auto d, std::size_t i) HWY_ATTR {
    auto any = hn::Zero(d);
    for (std::size_t row = 0; row < rows.count; ++row)
      any = hn::Add(any, hn::LoadU(d, rows.weights[row] + i));
    // Nothing is known of most of the map.
    if (hn::AllTrue(d, hn::Eq(any, hn::Zero(d)))) return;
    auto w = hn::LoadU(d, sums.w.data() + i);
    auto wy = hn::LoadU(d, sums.wy.data() + i);
    auto wyy = hn::LoadU(d, sums.wyy.data() + i);
    auto z = hn::LoadU(d, sums.z.data() + i);
    auto zy = hn::LoadU(d, sums.zy.data() + i);
    for (std::size_t row = 0; row < rows.count; ++row) {
      const auto y = hn::Set(d, rows.y[row]);
      const auto weight = hn::LoadU(d, rows.weights[row] + i);
      const auto weighted = hn::Mul(weight, hn::LoadU(d, rows.heights[row] + i));
      const auto weight_y = hn::Mul(weight, y);
      w = hn::Add(w, weight);
      wy = hn::Add(wy, weight_y);
      wyy = hn::Add(wyy, hn::Mul(weight_y, y));
      z = hn::Add(z, weighted);
      zy = hn::Add(zy, hn::Mul(weighted, y));
    }
    hn::StoreU(w, d, sums.w.data() + i);
    hn::StoreU(wy, d, sums.wy.data() + i);
    hn::StoreU(wyy, d, sums.wyy.data() + i);
    hn::StoreU(z, d, sums.z.data() + i);
    hn::StoreU(zy, d, sums.zy.data() + i);
  };
  ForWholeVectors(count, add);
}

void SumColumns(const ColumnSums& columns, int cells, int cells_before, float cell_size,
                BlockSums& sums, std::size_t row, std::size_t count) {
  const auto size = static_cast<int>(columns.w.size());
  const float middle = 0.5F * static_cast<float>(cells - 1);
  for (std::size_t block = 0; block < count; ++block) {
    const int first = static_cast<int>(block) * cells - cells_before;
    float w = 0.0F, x = 0.0F, y = 0.0F, xx = 0.0F, xy = 0.0F, yy = 0.0F, z = 0.0F, xz = 0.0F,
          yz = 0.0F;
    const int begin = std::max(-first, 0);
    const int end = std::min(cells, size - first);
    for (int i = begin; i < end; ++i) w += columns.w[static_cast<std::size_t>(first + i)];
    // Nothing is known of many blocks.
    for (int i = begin; i < (w == 0.0F ? begin : end); ++i) {
      const auto column = static_cast<std::size_t>(first + i);
      const float in_x = (static_cast<float>(i) - middle) * cell_size;
      const float own_w = columns.w[column];
      const float own_y = columns.wy[column];
      const float own_z = columns.z[column];
      x += own_w * in_x;
      xx += own_w * (in_x * in_x);
      y += own_y;
      xy += own_y * in_x;
      yy += columns.wyy[column];
      z += own_z;
      xz += own_z * in_x;
      yz += columns.zy[column];
    }
    const std::size_t to = row + block;
    sums.w[to] = w, sums.x[to] = x, sums.y[to] = y;
    sums.xx[to] = xx, sums.xy[to] = xy, sums.yy[to] = yy;
    sums.z[to] = z, sums.xz[to] = xz, sums.yz[to] = yz;
  }
}

void BlendRows(const BlockPlanes& planes, std::size_t own_row, std::size_t other_row,
               const BlockShare& share, BlockPlanes& at_y) {
  const std::size_t count = at_y.height.size();
  const float a = share.share;
  const float b = 1.0F - a;
  const auto blend = [&](const std::vector<float>& from, std::vector<float>& to) HWY_ATTR {
    const float* HWY_RESTRICT own = from.data() + own_row;
    const float* HWY_RESTRICT other = from.data() + other_row;
    float* HWY_RESTRICT out = to.data();
    GROUNDGRID_VECTOR_LOOP
    for (std::size_t i = 0; i < count; ++i) out[i] = a * own[i] + b * other[i];
  };
  const auto move = [&](const std::vector<float>& from, const std::vector<float>& slope, float away,
                        float away_other, std::vector<float>& to) HWY_ATTR {
    const float* HWY_RESTRICT own = from.data() + own_row;
    const float* HWY_RESTRICT other = from.data() + other_row;
    const float* HWY_RESTRICT own_slope = slope.data() + own_row;
    const float* HWY_RESTRICT other_slope = slope.data() + other_row;
    float* HWY_RESTRICT out = to.data();
    GROUNDGRID_VECTOR_LOOP
    for (std::size_t i = 0; i < count; ++i)
      out[i] = a * (own[i] + own_slope[i] * away) + b * (other[i] + other_slope[i] * away_other);
  };
  move(planes.height, planes.slope_y, share.away, share.away_other, at_y.height);
  blend(planes.slope_x, at_y.slope_x);
  blend(planes.slope_y, at_y.slope_y);
  move(planes.variance_height, planes.variance_y, share.away * share.away,
       share.away_other * share.away_other, at_y.variance_height);
  blend(planes.variance_x, at_y.variance_x);
  blend(planes.variance_y, at_y.variance_y);
}

void ExpectRow(const BlockPlanes& at_y, std::span<const BlockShare> shares,
               const BlockScatter& scatter, BlockPlanes& planes, std::size_t row) {
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < shares.size(); ++i) {
    const BlockShare& x = shares[i];
    const auto own = static_cast<std::size_t>(x.own);
    const auto other = static_cast<std::size_t>(x.other);
    const float a = x.share;
    const float b = 1.0F - a;
    planes.height[row + i] = a * (at_y.height[own] + at_y.slope_x[own] * x.away) +
                             b * (at_y.height[other] + at_y.slope_x[other] * x.away_other);
    planes.slope_x[row + i] = a * at_y.slope_x[own] + b * at_y.slope_x[other];
    planes.slope_y[row + i] = a * at_y.slope_y[own] + b * at_y.slope_y[other];
    planes.variance_height[row + i] =
        a * (at_y.variance_height[own] + at_y.variance_x[own] * (x.away * x.away)) +
        b * (at_y.variance_height[other] + at_y.variance_x[other] * (x.away_other * x.away_other)) +
        scatter.variance_height;
    planes.variance_x[row + i] =
        a * at_y.variance_x[own] + b * at_y.variance_x[other] + scatter.variance_slope;
    planes.variance_y[row + i] =
        a * at_y.variance_y[own] + b * at_y.variance_y[other] + scatter.variance_slope;
  }
}

void CorrectRow(const BlockSums& sums, const BlockScatter& scatter, BlockPlanes& planes,
                std::size_t row, std::size_t count) {
  const float* HWY_RESTRICT w = sums.w.data() + row;
  const float* HWY_RESTRICT x = sums.x.data() + row;
  const float* HWY_RESTRICT y = sums.y.data() + row;
  const float* HWY_RESTRICT xx = sums.xx.data() + row;
  const float* HWY_RESTRICT xy = sums.xy.data() + row;
  const float* HWY_RESTRICT yy = sums.yy.data() + row;
  const float* HWY_RESTRICT z = sums.z.data() + row;
  const float* HWY_RESTRICT xz = sums.xz.data() + row;
  const float* HWY_RESTRICT yz = sums.yz.data() + row;
  float* HWY_RESTRICT height = planes.height.data() + row;
  float* HWY_RESTRICT slope_x = planes.slope_x.data() + row;
  float* HWY_RESTRICT slope_y = planes.slope_y.data() + row;
  float* HWY_RESTRICT variance_height = planes.variance_height.data() + row;
  float* HWY_RESTRICT variance_x = planes.variance_x.data() + row;
  float* HWY_RESTRICT variance_y = planes.variance_y.data() + row;
  const float per_cell = 1.0F / scatter.variance_cell;
  const float most = scatter.independent_cells;
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    const float f = per_cell * (w[i] > most ? most / w[i] : 1.0F);
    // Normal equations of the correction: a symmetric matrix, its right side, its cofactors. Sums
    // of 0 leave what is expected as it is.
    const float a00 = f * w[i] + 1.0F / variance_height[i];
    const float a01 = f * x[i];
    const float a02 = f * y[i];
    const float a11 = f * xx[i] + 1.0F / variance_x[i];
    const float a12 = f * xy[i];
    const float a22 = f * yy[i] + 1.0F / variance_y[i];
    const float b0 = f * (z[i] - height[i] * w[i] - slope_x[i] * x[i] - slope_y[i] * y[i]);
    const float b1 = f * (xz[i] - height[i] * x[i] - slope_x[i] * xx[i] - slope_y[i] * xy[i]);
    const float b2 = f * (yz[i] - height[i] * y[i] - slope_x[i] * xy[i] - slope_y[i] * yy[i]);
    const float c00 = a11 * a22 - a12 * a12;
    const float c01 = a02 * a12 - a01 * a22;
    const float c02 = a01 * a12 - a02 * a11;
    const float c11 = a00 * a22 - a02 * a02;
    const float c12 = a01 * a02 - a00 * a12;
    const float c22 = a00 * a11 - a01 * a01;
    const float inverse = 1.0F / (a00 * c00 + a01 * c01 + a02 * c02);
    height[i] += (c00 * b0 + c01 * b1 + c02 * b2) * inverse;
    slope_x[i] += (c01 * b0 + c11 * b1 + c12 * b2) * inverse;
    slope_y[i] += (c02 * b0 + c12 * b1 + c22 * b2) * inverse;
    variance_height[i] = c00 * inverse;
    variance_x[i] = c11 * inverse;
    variance_y[i] = c22 * inverse;
  }
}

void EvaluateAlong(const BlockPlanes& planes, std::size_t row, const CellPlaces& places,
                   SurfaceRow& surface) {
  const hn::ScalableTag<float> d;
  const auto step = static_cast<std::int32_t>(hn::Lanes(d));
  for (const CellRun& run : places.runs) {
    const std::size_t before = row + static_cast<std::size_t>(run.before);
    const std::size_t after = row + static_cast<std::size_t>(run.after);
    const auto height_before = hn::Set(d, planes.height[before]);
    const auto height_after = hn::Set(d, planes.height[after]);
    const auto slope_before = hn::Set(d, planes.slope_x[before]);
    const auto slope_after = hn::Set(d, planes.slope_x[after]);
    const auto slope_y_before = hn::Set(d, planes.slope_y[before]);
    const auto bend_y = hn::Set(d, planes.slope_y[after] - planes.slope_y[before]);
    // What a vector writes beyond its run, the next run writes again.
    for (std::int32_t i = run.begin; i < run.end; i += step) {
      const auto share = hn::LoadU(d, places.share_after.data() + i);
      const auto left = hn::Add(height_before,
                                hn::Mul(slope_before, hn::LoadU(d, places.from_before.data() + i)));
      const auto right =
          hn::Add(height_after, hn::Mul(slope_after, hn::LoadU(d, places.from_after.data() + i)));
      hn::StoreU(hn::Add(left, hn::Mul(share, hn::Sub(right, left))), d, surface.height.data() + i);
      hn::StoreU(hn::Add(slope_y_before, hn::Mul(share, bend_y)), d, surface.slope_y.data() + i);
    }
  }
}

void EvaluateBetween(const SurfaceBetween& between, std::size_t count,
                     float* HWY_RESTRICT surface) {
  const float* HWY_RESTRICT lower = between.lower->height.data();
  const float* HWY_RESTRICT lower_slope = between.lower->slope_y.data();
  const float* HWY_RESTRICT upper = between.upper->height.data();
  const float* HWY_RESTRICT upper_slope = between.upper->slope_y.data();
  const SurfaceBetween at = between;
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < count; ++i) {
    const float from_lower = lower[i] + lower_slope[i] * at.from_lower;
    const float from_upper = upper[i] + upper_slope[i] * at.from_upper;
    surface[i] = from_lower + at.share_upper * (from_upper - from_lower);
  }
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {

HWY_EXPORT(AddRows);
HWY_EXPORT(SumColumns);
HWY_EXPORT(BlendRows);
HWY_EXPORT(ExpectRow);
HWY_EXPORT(CorrectRow);
HWY_EXPORT(EvaluateAlong);
HWY_EXPORT(EvaluateBetween);

void add_rows(const CellRows& rows, std::size_t count, ColumnSums& sums) {
  HWY_DYNAMIC_DISPATCH(AddRows)(rows, count, sums);
}

void sum_columns(const ColumnSums& columns, int cells, int cells_before, float cell_size,
                 BlockSums& sums, std::size_t row, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(SumColumns)
  (columns, cells, cells_before, cell_size, sums, row, count);
}

void blend_rows(const BlockPlanes& planes, std::size_t own_row, std::size_t other_row,
                const BlockShare& share, BlockPlanes& at_y) {
  HWY_DYNAMIC_DISPATCH(BlendRows)(planes, own_row, other_row, share, at_y);
}

void expect_row(const BlockPlanes& at_y, std::span<const BlockShare> shares,
                const BlockScatter& scatter, BlockPlanes& planes, std::size_t row) {
  HWY_DYNAMIC_DISPATCH(ExpectRow)(at_y, shares, scatter, planes, row);
}

void correct_row(const BlockSums& sums, const BlockScatter& scatter, BlockPlanes& planes,
                 std::size_t row, std::size_t count) {
  HWY_DYNAMIC_DISPATCH(CorrectRow)(sums, scatter, planes, row, count);
}

void evaluate_along(const BlockPlanes& planes, std::size_t row, const CellPlaces& places,
                    SurfaceRow& surface) {
  HWY_DYNAMIC_DISPATCH(EvaluateAlong)(planes, row, places, surface);
}

void evaluate_between(const SurfaceBetween& between, std::size_t count, float* surface) {
  HWY_DYNAMIC_DISPATCH(EvaluateBetween)(between, count, surface);
}

}  // namespace groundgrid
#endif
