#include "simulation/drive.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace groundgrid::simulation {
namespace {

class OnASlope : public ::testing::Test {
 protected:
  static Ground slope(const Eigen::Vector2d& place) { return {0.1 * place.x(), 40, 0.0}; }

  OnASlope()
      : scene_{.path = std::make_shared<const Path>(std::vector<Bend>{}, 60.0, 30.0),
               .ground = slope,
               .lane_m = -1.7,
               .speed_mps = 10.0},
        terrain_(*scene_.path, 60.0, slope, runner_) {}

  TileRunner runner_{1};
  Scene scene_;
  Terrain terrain_;
};

TEST_F(OnASlope, TheDriveBeginsLevelInItsLane) {
  const Eigen::Isometry3d pose = Drive(scene_, terrain_, 1).pose(0.0);
  EXPECT_TRUE(pose.linear().isIdentity(0.0));
  EXPECT_NEAR(pose.translation().y(), -1.7, 1e-9);
  EXPECT_NEAR(pose.translation().z(), 0.0, 1e-4);
}

TEST_F(OnASlope, TheVehicleTakesItsPitchAndHeight) {
  const Eigen::Isometry3d pose = Drive(scene_, terrain_, 1).pose(4.0);
  EXPECT_NEAR(pose.translation().x(), 40.0, 1e-6);
  EXPECT_NEAR(pose.translation().z(), 4.0, 0.011);
  const double climb = std::asin(pose.linear()(2, 0));
  EXPECT_NEAR(climb, std::atan(0.1), 0.0051);
}

}  // namespace
}  // namespace groundgrid::simulation
