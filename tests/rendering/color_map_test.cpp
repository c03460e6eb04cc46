#include "rendering/color_map.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "image_checks.hpp"

namespace groundgrid::rendering {
namespace {

// Relative luminance as sRGB defines it, by the simple power of 2.2.
double luminance(Color color) {
  const auto linear = [](std::uint8_t value) { return std::pow(value / 255.0, 2.2); };
  return 0.2126 * linear(color.red) + 0.7152 * linear(color.green) + 0.0722 * linear(color.blue);
}

TEST(ColorMap, IsAStraightLineBetweenItsStops) {
  static constexpr std::array kStops{Color{0, 0, 0}, Color{100, 200, 0}, Color{100, 0, 50}};
  const ColorMap map(kStops);
  EXPECT_EQ(map.at(0.0), (Color{0, 0, 0}));
  EXPECT_EQ(map.at(0.25), (Color{50, 100, 0}));
  EXPECT_EQ(map.at(0.5), (Color{100, 200, 0}));
  EXPECT_EQ(map.at(0.75), (Color{100, 100, 25}));
  EXPECT_EQ(map.at(1.0), (Color{100, 0, 50}));
}

TEST(ColorMap, KeepsItsEndsBeyondThem) {
  EXPECT_EQ(height_colors().at(-3.0), height_colors().at(0.0));
  EXPECT_EQ(height_colors().at(3.0), height_colors().at(1.0));
}

TEST(ColorMap, OfHeightsGrowsLighterAllTheWay) {
  for (int i = 0; i < 100; ++i)
    EXPECT_LT(luminance(height_colors().at(i / 100.0)),
              luminance(height_colors().at((i + 1) / 100.0)))
        << i;
}

TEST(ColorMap, OfErrorsIsWhiteAtZeroAndDarkerToBothSides) {
  EXPECT_EQ(error_colors().at(0.5), kWhite);
  for (int i = 0; i < 50; ++i) {
    EXPECT_LT(luminance(error_colors().at(i / 100.0)),
              luminance(error_colors().at((i + 1) / 100.0)));
    EXPECT_LT(luminance(error_colors().at(1.0 - i / 100.0)),
              luminance(error_colors().at(1.0 - (i + 1) / 100.0)));
  }
  EXPECT_GT(error_colors().at(0.1).blue, error_colors().at(0.1).red);
  EXPECT_GT(error_colors().at(0.9).red, error_colors().at(0.9).blue);
}

}  // namespace
}  // namespace groundgrid::rendering
