// The loops of the ground surface over all cells, compiled for each instruction set.
#include "core/kernels/surface_kernels.hpp"

#include <cstddef>

#include "core/kernels/vector_loop.hpp"
#include "core/method/equations.hpp"

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/surface_kernels.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

#include "core/kernels/whole_vectors-inl.hpp"

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

void CollectKnown(const std::uint8_t* HWY_RESTRICT is_ground, const float* HWY_RESTRICT map_heights,
                  const float* HWY_RESTRICT confidence, float remembered, std::size_t cells,
                  float* HWY_RESTRICT heights) {
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < cells; ++i) {
    const float known = confidence[i] >= remembered ? map_heights[i] : kUnknownHeight;
    heights[i] = is_ground[i] != 0 ? heights[i] : known;
  }
}

void WeighKnown(const float* HWY_RESTRICT heights, std::size_t cells, float* HWY_RESTRICT weights) {
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < cells; ++i) weights[i] = heights[i] == kUnknownHeight ? 0.0F : 1.0F;
}

/// The surface at the cells of a vector.
template <class D>
HWY_INLINE hn::Vec<D> SurfaceAt(D d, const SurfaceBetween& between, std::size_t i) {
  const auto along = [&](const SurfaceRow& row, float away) HWY_ATTR {
    return hn::Add(hn::LoadU(d, row.height.data() + i),
                   hn::Mul(hn::LoadU(d, row.slope_y.data() + i), hn::Set(d, away)));
  };
  const auto lower = along(*between.lower, between.from_lower);
  const auto upper = along(*between.upper, between.from_upper);
  return hn::Add(lower, hn::Mul(hn::Set(d, between.share_upper), hn::Sub(upper, lower)));
}

void Reweight(const float* HWY_RESTRICT heights, const SurfaceBetween& surface,
              const HeightTolerance& most, std::size_t cells, float* HWY_RESTRICT weights) {
  const auto weigh = [&](auto d, std::size_t i) HWY_ATTR {
    const auto height = hn::LoadU(d, heights + i);
    if (hn::AllTrue(d, hn::Eq(height, hn::Set(d, kUnknownHeight))))
      return hn::StoreU(hn::Zero(d), d, weights + i);
    const auto off = hn::Sub(height, SurfaceAt(d, surface, i));
    const auto tolerance =
        hn::IfThenElse(hn::Gt(off, hn::Zero(d)), hn::Set(d, most.above), hn::Set(d, most.below));
    // Never more than 1: within the tolerance.
    const auto ratio = hn::Div(tolerance, hn::Max(hn::Abs(off), tolerance));
    hn::StoreU(hn::Mul(ratio, ratio), d, weights + i);
  };
  ForWholeVectors(cells, weigh);
}

void Judge(const float* HWY_RESTRICT heights, const SurfaceBetween& surface, float step,
           std::size_t cells, std::uint8_t* HWY_RESTRICT standing,
           float* HWY_RESTRICT surface_there) {
  const auto number = [](Standing of) { return static_cast<std::int32_t>(of); };
  const auto judge = [&](auto d, std::size_t i) HWY_ATTR {
    const hn::RebindToSigned<decltype(d)> di;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    const auto height = hn::LoadU(d, heights + i);
    const auto known = hn::Ne(height, hn::Set(d, kUnknownHeight));
    if (hn::AllFalse(d, known)) return hn::StoreU(hn::Zero(bytes), bytes, standing + i);
    const auto at = SurfaceAt(d, surface, i);
    hn::StoreU(at, d, surface_there + i);
    const auto raised = hn::Gt(height, hn::Add(at, hn::Set(d, step)));
    const auto verdict =
        hn::IfThenElse(hn::RebindMask(di, raised), hn::Set(di, number(Standing::raised)),
                       hn::Set(di, number(Standing::on_surface)));
    const auto all = hn::IfThenElseZero(hn::RebindMask(di, known), verdict);
    hn::StoreU(hn::DemoteTo(bytes, all), bytes, standing + i);
  };
  ForWholeVectors(cells, judge);
}

void WeighSurface(const std::uint8_t* HWY_RESTRICT standing, std::size_t cells,
                  float* HWY_RESTRICT weights) {
  constexpr auto kOnSurface = static_cast<std::uint8_t>(Standing::on_surface);
  GROUNDGRID_VECTOR_LOOP
  for (std::size_t i = 0; i < cells; ++i) weights[i] = standing[i] == kOnSurface ? 1.0F : 0.0F;
}

void FillCells(const FilledCells& cells, float decay) {
  const auto* HWY_RESTRICT standing = reinterpret_cast<const std::uint8_t*>(cells.standing);
  const SurfaceBetween along = *cells.surface;
  const auto fill = [&](auto d, std::size_t i) HWY_ATTR {
    const hn::RebindToSigned<decltype(d)> di;
    const hn::Rebind<std::uint8_t, decltype(d)> bytes;
    const auto is = [&](const std::uint8_t* numbers, std::int32_t number) HWY_ATTR {
      const auto of_cells = hn::PromoteTo(di, hn::LoadU(bytes, numbers + i));
      return hn::RebindMask(d, hn::Eq(of_cells, hn::Set(di, number)));
    };
    const auto unseen = is(cells.is_ground, 0);
    const auto on_surface = is(standing, static_cast<std::int32_t>(Standing::on_surface));
    const auto confidence = hn::LoadU(d, cells.confidence + i);
    const auto decayed = hn::Sub(confidence, hn::Div(confidence, hn::Set(d, decay)));
    const auto kept = hn::IfThenZeroElse(hn::Lt(decayed, hn::Set(d, kForgotten)), decayed);
    hn::StoreU(hn::IfThenElse(unseen, kept, confidence), d, cells.confidence + i);
    const auto unknown = hn::And(unseen, hn::Not(on_surface));
    const auto height = hn::LoadU(d, cells.height + i);
    hn::StoreU(hn::IfThenElse(unknown, SurfaceAt(d, along, i), height), d, cells.height + i);
  };
  ForWholeVectors(cells.count, fill);
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {
namespace {

HWY_EXPORT(CollectKnown);
HWY_EXPORT(WeighKnown);
HWY_EXPORT(Reweight);
HWY_EXPORT(Judge);
HWY_EXPORT(WeighSurface);
HWY_EXPORT(FillCells);

}  // namespace

void collect_known(std::span<const std::uint8_t> is_ground, std::span<const float> map_heights,
                   std::span<const float> confidence, float remembered, std::span<float> heights) {
  HWY_DYNAMIC_DISPATCH(CollectKnown)
  (is_ground.data(), map_heights.data(), confidence.data(), remembered, heights.size(),
   heights.data());
}

void weigh_known(const float* heights, std::size_t count, float* weights) {
  HWY_DYNAMIC_DISPATCH(WeighKnown)(heights, count, weights);
}

void reweight(const float* heights, const SurfaceBetween& surface, const HeightTolerance& tolerance,
              std::size_t count, float* weights) {
  HWY_DYNAMIC_DISPATCH(Reweight)(heights, surface, tolerance, count, weights);
}

void judge(const float* heights, const SurfaceBetween& surface, float step, std::size_t count,
           Standing* standing, float* surface_there) {
  HWY_DYNAMIC_DISPATCH(Judge)
  (heights, surface, step, count, reinterpret_cast<std::uint8_t*>(standing), surface_there);
}

void weigh_surface(const Standing* standing, std::size_t count, float* weights) {
  HWY_DYNAMIC_DISPATCH(WeighSurface)
  (reinterpret_cast<const std::uint8_t*>(standing), count, weights);
}

void fill_cells(const FilledCells& cells, float decay) {
  HWY_DYNAMIC_DISPATCH(FillCells)(cells, decay);
}

}  // namespace groundgrid
#endif
