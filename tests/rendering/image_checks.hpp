#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <ostream>

#include "rendering/image.hpp"

namespace groundgrid::rendering {

inline void PrintTo(const Color& color, std::ostream* out) {
  *out << '(' << int{color.red} << ", " << int{color.green} << ", " << int{color.blue} << ')';
}

}  // namespace groundgrid::rendering

namespace groundgrid::test {

/// Pixels of exactly that colour.
inline std::size_t count_of(const rendering::Image& image, rendering::Color color) {
  return static_cast<std::size_t>(
      std::count(image.pixels.begin(), image.pixels.end(), rendering::pixel_of(color)));
}

/// Whether a pixel is of that colour or, at the edge of something small, half way to white or more.
inline bool is_tinted(rendering::Color pixel, rendering::Color color) {
  const auto white_part = [](int value, int full) {
    return full == 255 ? -1 : 255 * (value - full) / (255 - full);
  };
  int least = 255;
  int greatest = 0;
  for (const int part : {white_part(pixel.red, color.red), white_part(pixel.green, color.green),
                         white_part(pixel.blue, color.blue)}) {
    if (part < 0) return false;
    least = std::min(least, part);
    greatest = std::max(greatest, part);
  }
  return greatest <= 140 && greatest - least <= 12;
}

}  // namespace groundgrid::test
