// Lists of cells from a byte for each of them, compiled for each instruction set.
#include "core/kernels/marked_cells.hpp"

#include <algorithm>
#include <cstddef>

#undef HWY_TARGET_INCLUDE
// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): Highway compiles this file again and again.
#define HWY_TARGET_INCLUDE "core/kernels/marked_cells.cpp"
#include <hwy/foreach_target.h>
// After foreach_target.h.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace groundgrid::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

// Most cells are empty: so many are passed over at once.
constexpr std::size_t kMarkedTogether = 64;

bool AnyMarked(const std::uint8_t* HWY_RESTRICT cells, std::uint8_t mark) {
  std::uint8_t all = 0;
  for (std::size_t i = 0; i < kMarkedTogether; ++i) all |= cells[i];
  return (all & mark) != 0;
}

/// Numbers of the marked cells, the first of `cells` having this one; `found` has room for all and
/// for a vector more.
std::size_t ListMarked(std::span<const std::uint8_t> cells, std::uint8_t mark,
                       std::uint32_t first_number, std::uint32_t* found) {
  const hn::ScalableTag<std::uint32_t> d;
  const hn::Rebind<std::uint8_t, decltype(d)> bytes;
  const auto marks = hn::Set(d, mark);
  std::size_t number = 0;
  std::size_t i = 0;
  for (; i + kMarkedTogether <= cells.size(); i += kMarkedTogether) {
    if (!AnyMarked(cells.data() + i, mark)) continue;
    auto numbers = hn::Iota(d, first_number + static_cast<std::uint32_t>(i));
    for (std::size_t k = i; k < i + kMarkedTogether; k += hn::Lanes(d)) {
      const auto marked = hn::TestBit(hn::PromoteTo(d, hn::LoadU(bytes, cells.data() + k)), marks);
      hn::StoreU(hn::Compress(numbers, marked), d, found + number);
      numbers = hn::Add(numbers, hn::Set(d, static_cast<std::uint32_t>(hn::Lanes(d))));
      number += hn::CountTrue(d, marked);
    }
  }
  for (; i < cells.size(); ++i)
    if ((cells[i] & mark) != 0) found[number++] = first_number + static_cast<std::uint32_t>(i);
  return number;
}

}  // namespace groundgrid::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace groundgrid {

HWY_EXPORT(ListMarked);

void append_marked(std::span<const std::uint8_t> cells, std::uint8_t mark,
                   std::vector<std::uint32_t>& found) {
  constexpr std::size_t kListedAtOnce = 4096;
  constexpr std::size_t kSpare = 64;
  std::uint32_t some[kListedAtOnce + kSpare];
  const auto list = HWY_DYNAMIC_DISPATCH(ListMarked);
  for (std::size_t first = 0; first < cells.size(); first += kListedAtOnce) {
    const std::size_t count = std::min(kListedAtOnce, cells.size() - first);
    const std::size_t number =
        list(cells.subspan(first, count), mark, static_cast<std::uint32_t>(first), some);
    found.insert(found.end(), some, some + number);
  }
}

}  // namespace groundgrid
#endif
