#include "simulation/relief.hpp"

#include <gtest/gtest.h>

namespace groundgrid::simulation {
namespace {

// The ditch's sides are 0.8 m wide: down to 0.8, its bottom to 1.2, up from there.
constexpr Earthwork kEarthwork{.gradient = 0.5, .ditch_m = 0.4, .bottom_m = 0.4};

TEST(BesideRoad, LevelLandLiesBehindADitch) {
  EXPECT_NEAR(beside_road(0.0, 0.0, kEarthwork), 0.0, 1e-12);
  EXPECT_NEAR(beside_road(0.4, 0.0, kEarthwork), -0.2, 1e-12);
  EXPECT_NEAR(beside_road(1.0, 0.0, kEarthwork), -0.4, 1e-12);
  EXPECT_NEAR(beside_road(1.6, 0.0, kEarthwork), -0.2, 1e-12);
  EXPECT_NEAR(beside_road(5.0, 0.0, kEarthwork), 0.0, 1e-12);
}

TEST(BesideRoad, LowLandIsReachedByAnEmbankmentWithoutADitch) {
  EXPECT_NEAR(beside_road(1.0, -3.0, kEarthwork), -0.5, 1e-12);
  EXPECT_NEAR(beside_road(4.0, -3.0, kEarthwork), -2.0, 1e-12);
  EXPECT_NEAR(beside_road(6.5, -3.0, kEarthwork), -3.0, 1e-12);
}

TEST(BesideRoad, HighLandIsCutInto) {
  EXPECT_NEAR(beside_road(1.0, 2.0, kEarthwork), -0.4, 1e-12);
  EXPECT_NEAR(beside_road(3.2, 2.0, kEarthwork), 0.6, 1e-12);
  EXPECT_NEAR(beside_road(10.0, 2.0, kEarthwork), 2.0, 1e-12);
}

}  // namespace
}  // namespace groundgrid::simulation
