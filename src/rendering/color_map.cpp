#include "rendering/color_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace groundgrid::rendering {
namespace {

// Eleven places of viridis (matplotlib, CC0).
constexpr std::array kHeightStops{Color{68, 1, 84},    Color{72, 36, 117},  Color{65, 68, 135},
                                  Color{53, 95, 141},  Color{42, 120, 142}, Color{33, 145, 140},
                                  Color{34, 168, 132}, Color{68, 191, 112}, Color{122, 209, 81},
                                  Color{189, 223, 38}, Color{253, 231, 37}};

// Even steps of ColorBrewer's RdBu with eleven classes, blue first and a pure white middle.
constexpr std::array kErrorStops{Color{5, 48, 97},     Color{33, 102, 172},  Color{67, 147, 195},
                                 Color{146, 197, 222}, Color{209, 229, 240}, Color{255, 255, 255},
                                 Color{253, 219, 199}, Color{244, 165, 130}, Color{214, 96, 77},
                                 Color{178, 24, 43},   Color{103, 0, 31}};

std::uint8_t mix(std::uint8_t first, std::uint8_t second, double fraction) {
  return static_cast<std::uint8_t>(std::lround(first + fraction * (second - first)));
}

}  // namespace

Color mix(Color first, Color second, double fraction) {
  return {mix(first.red, second.red, fraction), mix(first.green, second.green, fraction),
          mix(first.blue, second.blue, fraction)};
}

Color ColorMap::at(double fraction) const {
  const double place = std::clamp(fraction, 0.0, 1.0) * static_cast<double>(stops_.size() - 1);
  const std::size_t below = std::min(static_cast<std::size_t>(place), stops_.size() - 2);
  return mix(stops_[below], stops_[below + 1], place - static_cast<double>(below));
}

const ColorMap& height_colors() {
  static constexpr ColorMap kMap(kHeightStops);
  return kMap;
}

const ColorMap& error_colors() {
  static constexpr ColorMap kMap(kErrorStops);
  return kMap;
}

}  // namespace groundgrid::rendering
