#include "rendering/palette.hpp"

#include <algorithm>
#include <cstddef>
#include <stdexcept>

#include "rendering/color_map.hpp"

namespace groundgrid::rendering {
namespace {

constexpr std::size_t kMostColors = 12;
constexpr int kGreys = 40;
constexpr int kStepsToWhite = 12;
constexpr int kStepsToBlack = 6;

int squared_distance(Color one, Color other) {
  const int red = one.red - other.red;
  const int green = one.green - other.green;
  const int blue = one.blue - other.blue;
  return red * red + green * green + blue * blue;
}

}  // namespace

Palette::Palette(std::span<const Color> main_colors) {
  if (main_colors.size() > kMostColors)
    throw std::invalid_argument("a palette is made of at most twelve colours");
  for (const Color color : main_colors) {
    for (int i = 0; i < kStepsToWhite; ++i)
      colors_.push_back(mix(color, kWhite, static_cast<double>(i) / kStepsToWhite));
    for (int i = 1; i < kStepsToBlack; ++i)
      colors_.push_back(mix(color, kBlack, static_cast<double>(i) / kStepsToBlack));
  }
  for (int i = 0; i < kGreys; ++i)
    colors_.push_back(mix(kBlack, kWhite, static_cast<double>(i) / (kGreys - 1)));
}

std::uint8_t Palette::nearest(Color color) const {
  const auto found = std::min_element(
      colors_.begin(), colors_.end(), [color](const Color& entry, const Color& best) {
        return squared_distance(entry, color) < squared_distance(best, color);
      });
  return static_cast<std::uint8_t>(found - colors_.begin());
}

std::vector<std::uint8_t> Palette::indices(const Image& image) {
  std::vector<std::uint8_t> result;
  result.reserve(image.pixels.size());
  for (const std::uint32_t pixel : image.pixels) {
    const auto [entry, is_new] = known_.try_emplace(pixel);
    if (is_new) entry->second = nearest(color_of(pixel));
    result.push_back(entry->second);
  }
  return result;
}

}  // namespace groundgrid::rendering
