#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "rendering/color.hpp"

namespace groundgrid::rendering {

/// A pixel of that colour.
constexpr std::uint32_t pixel_of(Color color) {
  return 0xFF000000U | std::uint32_t{color.red} << 16U | std::uint32_t{color.green} << 8U |
         std::uint32_t{color.blue};
}

/// The colour of a pixel.
constexpr Color color_of(std::uint32_t pixel) {
  return {static_cast<std::uint8_t>(pixel >> 16U), static_cast<std::uint8_t>(pixel >> 8U),
          static_cast<std::uint8_t>(pixel)};
}

/// Width and height in pixels.
struct ImageSize {
  int width = 0;
  int height = 0;

  [[nodiscard]] std::size_t pixels() const {
    return static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  }
  bool operator==(const ImageSize&) const = default;
};

/// Pixels row by row from the top, each 0xFFRRGGBB; kTransparent in an image that is to be pasted.
struct Image {
  ImageSize size{};
  std::vector<std::uint32_t> pixels{};

  [[nodiscard]] Color at(int x, int y) const {
    return color_of(pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                           static_cast<std::size_t>(x)]);
  }
};

inline constexpr std::uint32_t kTransparent = 0;

}  // namespace groundgrid::rendering
