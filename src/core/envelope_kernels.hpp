#pragma once

#include <cstddef>
#include <cstdint>

namespace groundgrid {

/// Higher than any height of an envelope can become, in steps of 0.1 mm.
constexpr std::int32_t kNoEnvelope = 1 << 29;

/// Heights that rise by so many steps of 0.1 mm from a cell to the next along a row or column, and
/// to the next along a diagonal.
struct EnvelopeRise {
  std::int32_t straight = 0;
  std::int32_t diagonal = 0;
};

/// Lets the heights of a row rise from the row beside it.
void spread_across(const std::int32_t* from, std::int32_t* row, std::size_t count,
                   const EnvelopeRise& rise);

/// Lets the heights of a row rise along it, from the first cell to the last or the other way.
void spread_forward(std::int32_t* row, std::size_t count, std::int32_t rise);
void spread_backward(std::int32_t* row, std::size_t count, std::int32_t rise);

/// Three rows of numbers, one above the other; NaN where there is none.
struct MedianRows {
  const float* below = nullptr;
  const float* own = nullptr;
  const float* above = nullptr;
};

/// Medians of the nine numbers in columns i, i + 1 and i + 2 of the rows, i from 0 to `count` - 1,
/// those that are NaN left out (of an even number the greater of the middle two), with weight 1.
/// Where there is none at all: 0 with weight 0.
void median_row(const MedianRows& rows, std::size_t count, float* medians, float* weights);

/// So many numbers more than are ranked must be readable.
constexpr std::size_t kRankSpare = 64;

/// The number before which `rank` others come when `count` of them, at least one more than that,
/// are put in order.
float ranked(const float* values, std::size_t count, std::size_t rank);

}  // namespace groundgrid
