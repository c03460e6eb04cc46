#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "rendering/color.hpp"
#include "rendering/image.hpp"

namespace groundgrid::rendering {

/// Up to 256 colours for pictures that consist of a few: each of these exactly, on its way to white
/// and to black as edges and shadows need it, and greys.
class Palette {
 public:
  /// For at most 12 colours. Throws std::invalid_argument where there are more.
  explicit Palette(std::span<const Color> main_colors);

  [[nodiscard]] const std::vector<Color>& colors() const { return colors_; }

  /// Of each pixel of an image the number of the nearest colour.
  std::vector<std::uint8_t> indices(const Image& image);

 private:
  [[nodiscard]] std::uint8_t nearest(Color color) const;

  std::vector<Color> colors_{};
  std::unordered_map<std::uint32_t, std::uint8_t> known_{};  ///< Of pixels looked up before.
};

}  // namespace groundgrid::rendering
