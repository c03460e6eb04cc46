#include "simulation/sensors.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace groundgrid::simulation {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;

TEST(Sensors, Hdl64eHasTwoBlocksOfBeams) {
  const Sensor sensor = make_sensor("hdl-64e");
  ASSERT_EQ(sensor.beams.size(), 64U);
  EXPECT_NEAR(sensor.beams[0].elevation_rad, 1.94 * kDegree, 1e-9);
  EXPECT_NEAR(sensor.beams[31].elevation_rad, -8.71 * kDegree, 1e-9);
  EXPECT_NEAR(sensor.beams[63].elevation_rad, -25.0 * kDegree, 1e-9);
  EXPECT_DOUBLE_EQ(sensor.beams[31].height_m, 0.198);
  EXPECT_DOUBLE_EQ(sensor.beams[32].height_m, 0.126);
  EXPECT_NEAR(360.0 / sensor.columns, 0.1674, 0.0001);
  EXPECT_DOUBLE_EQ(sensor.T_base_sensor().translation().z(), 1.73);
}

TEST(Sensors, TurningOnesLookAheadInTheMiddleOfAScanAndTurnClockwise) {
  const Sensor sensor{.name = "test", .columns = 4};
  const Beam level;
  const Eigen::Vector3d left_of_rear = sensor.direction(level, 0, 0);
  EXPECT_NEAR(left_of_rear.x(), -std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(left_of_rear.y(), std::sqrt(0.5), 1e-9);
  const Eigen::Vector3d right_of_front = sensor.direction(level, 2, 0);
  EXPECT_NEAR(right_of_front.x(), std::sqrt(0.5), 1e-9);
  EXPECT_NEAR(right_of_front.y(), -std::sqrt(0.5), 1e-9);
  EXPECT_DOUBLE_EQ(sensor.time_share(0), -0.375);
}

TEST(Sensors, AllDirectionsHaveLengthOne) {
  for (const std::string& name : sensor_names()) {
    const Sensor sensor = make_sensor(name);
    EXPECT_EQ(sensor.name, name);
    for (const Beam& beam : sensor.beams)
      for (int column = 0; column < sensor.columns; column += 97)
        EXPECT_NEAR(sensor.direction(beam, column, 3).norm(), 1.0, 1e-12);
  }
}

TEST(Sensors, CanHangUpsideDownAndAskew) {
  constexpr double kRight = 90.0 * kDegree;
  const Sensor sensor{.name = "test", .mount = {2.0, 1.0, 0.5, 2.0 * kRight, 0.0, kRight}};
  const Eigen::Isometry3d transform = sensor.T_base_sensor();
  const Eigen::Vector3d ahead = transform * Eigen::Vector3d(3.0, 0.0, 0.0);
  EXPECT_NEAR((ahead - Eigen::Vector3d(1.0, 3.5, 2.0)).norm(), 0.0, 1e-12);
  const Eigen::Vector3d above = transform * Eigen::Vector3d(0.0, 0.0, 0.4);
  EXPECT_NEAR((above - Eigen::Vector3d(1.0, 0.5, 1.6)).norm(), 0.0, 1e-12);
}

TEST(Sensors, OfAnUnknownNameAreAnError) {
  EXPECT_THROW(make_sensor("hdl-65"), std::invalid_argument);
}

}  // namespace
}  // namespace groundgrid::simulation
