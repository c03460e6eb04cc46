#pragma once

#include <span>

#include "rendering/color.hpp"

namespace groundgrid::rendering {

/// Between two colours: 0 is the first, 1 the second.
Color mix(Color first, Color second, double fraction);

/// Colours for the numbers of a range, on straight lines between stops at equal distances.
class ColorMap {
 public:
  /// At least two stops, which live as long as the map.
  constexpr explicit ColorMap(std::span<const Color> stops) : stops_(stops) {}

  /// The colour at a place from 0 (low) to 1 (high); beyond them that of the end.
  [[nodiscard]] Color at(double fraction) const;

 private:
  std::span<const Color> stops_;
};

/// For heights: dark blue over green to yellow, evenly lighter all the way, for any colour vision.
const ColorMap& height_colors();

/// For errors about 0: blue below, white at 0, red above, for any colour vision.
const ColorMap& error_colors();

}  // namespace groundgrid::rendering
