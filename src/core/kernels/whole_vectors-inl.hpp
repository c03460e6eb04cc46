// A loop over numbers by vectors, for one instruction set: included once for each of them.
#if defined(GROUNDGRID_WHOLE_VECTORS_INL) == defined(HWY_TARGET_TOGGLE)
#ifdef GROUNDGRID_WHOLE_VECTORS_INL
#undef GROUNDGRID_WHOLE_VECTORS_INL
#else
#define GROUNDGRID_WHOLE_VECTORS_INL
#endif

#include <hwy/highway.h>

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// Calls work(tag, first) for vectors that cover `count` numbers, each of them once: as long as
/// there are enough for a whole vector, then for ever shorter ones.
template <class Work>
HWY_INLINE void ForWholeVectors(std::size_t count, const Work& work) {
  std::size_t i = 0;
  const auto work_by = [&](auto d) HWY_ATTR {
    for (; i + hn::Lanes(d) <= count; i += hn::Lanes(d)) work(d, i);
  };
  work_by(hn::ScalableTag<float>());
  work_by(hn::CappedTag<float, 8>());
  work_by(hn::CappedTag<float, 4>());
  work_by(hn::CappedTag<float, 1>());
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
