#include "geotiff/hillshade.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace groundgrid::geotiff {
namespace {

constexpr int kSide = 5;

// Heights that rise by `east` and `north` metres a cell of 1 m.
std::vector<float> slanted(double east, double north) {
  std::vector<float> heights;
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column)
      heights.push_back(static_cast<float>(east * column - north * row));
  return heights;
}

std::vector<std::uint8_t> shade(const std::vector<float>& heights, double exaggeration = 1.0) {
  return hillshade({kSide, kSide, 1.0, 1.0, heights}, exaggeration);
}

TEST(Hillshade, IsTheSameAllOverLevelGround) {
  const auto level = shade(slanted(0.0, 0.0));
  EXPECT_EQ(std::count(level.begin(), level.end(), kLevelShade), kSide * kSide);
}

TEST(Hillshade, IsTheCosineOfTheAngleToASunInTheNorthWest) {
  // Faces the sun: light where the ground falls to the north-west, dark where it falls away.
  const double slope = std::sqrt(0.5);  // 45 degrees in all.
  EXPECT_EQ(shade(slanted(slope, -slope))[12], 255);
  EXPECT_LE(shade(slanted(-slope, slope))[12], 2);
  // A slope that runs across the sun's direction: 1 + 254 sin 45° cos 45°.
  EXPECT_NEAR(shade(slanted(slope, slope))[12], 128, 1);
}

TEST(Hillshade, ExaggerationMakesSlopesSteeper) {
  EXPECT_EQ(shade(slanted(0.1, 0.0), 3.0), shade(slanted(0.3, 0.0)));
}

TEST(Hillshade, IsZeroWhereThereIsNoHeight) {
  auto heights = slanted(0.0, 0.0);
  heights[7] = std::nanf("");
  EXPECT_EQ(shade(heights)[7], 0);
  EXPECT_GT(shade(heights)[24], 0);
}

TEST(Hillshade, NeedsAHeightForEachCell) {
  EXPECT_THROW((void)shade({1.0F, 2.0F}), std::invalid_argument);
}

}  // namespace
}  // namespace groundgrid::geotiff
