#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

#include "groundgrid/ground_grid.hpp"

namespace groundgrid {
namespace {

/// A square of points every 0.2 m, `height` below the sensor.
std::vector<float> floor_below(float height, int half_steps) {
  std::vector<float> xyz;
  for (int y = -half_steps; y <= half_steps; ++y)
    for (int x = -half_steps; x <= half_steps; ++x)
      xyz.insert(xyz.end(), {static_cast<float>(x) * 0.2F, static_cast<float>(y) * 0.2F, -height});
  return xyz;
}

std::optional<double> estimate(const std::vector<float>& xyz) {
  return estimate_sensor_height(PointView::from_floats(xyz.data(), xyz.size() / 3, 3));
}

TEST(EstimateSensorHeight, IsTheDepthOfTheFloor) {
  for (const float height : {0.4F, 1.73F, 2.5F, 4.0F}) {
    const std::optional<double> found = estimate(floor_below(height, 40));
    ASSERT_TRUE(found.has_value()) << height;
    EXPECT_NEAR(*found, static_cast<double>(height), 0.05);
  }
}

TEST(EstimateSensorHeight, AFlatRoofWithMorePointsDoesNotWin) {
  std::vector<float> xyz = floor_below(1.73F, 60);
  for (int i = 0; i < 40000; ++i)  // a car's roof of 4 m² close by, full of points
    xyz.insert(xyz.end(), {3.0F + static_cast<float>(i % 200) * 0.01F,
                           static_cast<float>(i / 200) * 0.01F, -0.3F});
  const std::optional<double> found = estimate(xyz);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, 1.73, 0.05);
}

TEST(EstimateSensorHeight, TheGroundMayBeInclined) {
  std::vector<float> xyz;
  for (int y = -60; y <= 60; ++y)
    for (int x = -60; x <= 60; ++x)
      xyz.insert(xyz.end(), {static_cast<float>(x) * 0.2F, static_cast<float>(y) * 0.2F,
                             -1.73F + 0.03F * 0.2F * static_cast<float>(x)});
  const std::optional<double> found = estimate(xyz);
  ASSERT_TRUE(found.has_value());
  EXPECT_NEAR(*found, 1.73, 0.05);
}

TEST(EstimateSensorHeight, TheOwnVehicleAndNearPointsDoNotCount) {
  std::vector<float> xyz = floor_below(1.73F, 8);  // little floor, and more of a roof close by
  for (int i = 0; i < 10000; ++i)
    xyz.insert(xyz.end(), {-4.0F + static_cast<float>(i % 100) * 0.08F,
                           -4.0F + static_cast<float>(i / 100) * 0.08F, -0.3F});
  const PointView points = PointView::from_floats(xyz.data(), xyz.size() / 3, 3);
  Config config;
  EXPECT_NEAR(estimate_sensor_height(points, config).value_or(0.0), 0.3, 0.05);
  config.vehicle.ego_vehicle_box_m = {-5.0, 5.0, -5.0, 5.0, -1.0, 0.0};
  EXPECT_NEAR(estimate_sensor_height(points, config).value_or(0.0), 1.73, 0.05);
}

TEST(EstimateSensorHeight, RejectsViewsThatReachOutOfTheirRecords) {
  const std::vector<float> xyz(30);
  PointView view = PointView::from_floats(xyz.data(), 10, 3);
  view.z_offset = 9;
  EXPECT_THROW(estimate_sensor_height(view), std::invalid_argument);
}

TEST(EstimateSensorHeight, IsNothingWhereThereIsNoFloor) {
  EXPECT_FALSE(estimate({}).has_value());
  EXPECT_FALSE(estimate({1.0F, 1.0F, -1.7F}).has_value());
  EXPECT_FALSE(estimate(floor_below(-3.0F, 40)).has_value());  // a ceiling
  std::vector<float> wall;
  for (int z = -20; z <= 20; ++z)
    for (int y = -50; y <= 50; ++y)
      wall.insert(wall.end(), {5.1F, static_cast<float>(y) * 0.1F, static_cast<float>(z) * 0.05F});
  EXPECT_FALSE(estimate(wall).has_value());
}

}  // namespace
}  // namespace groundgrid
