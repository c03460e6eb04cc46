// Mountings and several sensors.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "groundgrid/ground_grid.hpp"
#include "support/ray_caster.hpp"

namespace groundgrid {
namespace {

using testing::cast_scan;
using testing::pose;
using testing::Scene;
using testing::Score;
using testing::SimulatedScan;

Scene narrow_road() {
  Scene scene;
  scene.boxes = {{{10.0, -1.0, -1.0}, {14.0, 1.0, 2.0}},
                 {{3.0, 3.0, -1.0}, {7.0, 5.0, 1.9}},
                 {{-30.0, 8.0, -1.0}, {30.0, 9.0, 4.0}}};
  return scene;
}

Eigen::Isometry3d tilted(double pitch_deg, double roll_deg) {
  constexpr double kDegree = std::numbers::pi / 180.0;
  Eigen::Isometry3d mounting = pose(0.3, 0.0, 1.75);
  mounting.rotate(Eigen::AngleAxisd(pitch_deg * kDegree, Eigen::Vector3d::UnitY()));
  mounting.rotate(Eigen::AngleAxisd(roll_deg * kDegree, Eigen::Vector3d::UnitX()));
  return mounting;
}

/// Largest error of the terrain where there is confidence.
double worst_height(const TerrainView& terrain) {
  double worst = 0.0;
  for (int row = 0; row < terrain.size; ++row)
    for (int column = 0; column < terrain.size; ++column) {
      const TerrainCell cell = terrain.cell(column, row);
      if (cell.confidence > 0.1F) worst = std::max(worst, std::abs(cell.height));
    }
  return worst;
}

TEST(Sensors, TiltedMounting) {
  for (const auto& [pitch, roll] :
       {std::pair(5.0, 0.0), std::pair(-5.0, 0.0), std::pair(5.0, 4.0)}) {
    const Eigen::Isometry3d mounting = tilted(pitch, roll);
    const SimulatedScan simulated =
        cast_scan(narrow_road(), {}, Eigen::Isometry3d::Identity(), mounting, 1);
    SensorScan scan;
    scan.points = simulated.view();
    scan.T_base_sensor = mounting;
    GroundGrid grid;
    const Score score = testing::score(grid.process(scan).labels, simulated.truth);
    EXPECT_GE(score.ground_recall(), 0.98) << pitch << "° pitch";
    EXPECT_GE(score.obstacle_recall(), 0.98) << pitch << "° pitch";
    EXPECT_LT(worst_height(grid.terrain()), 0.1) << pitch << "° pitch";

    // Taken as level the same scan gives a terrain that climbs: the test can fail.
    scan.T_base_sensor = pose(0.3, 0.0, 1.75);
    GroundGrid level;
    level.process(scan);
    EXPECT_GT(worst_height(level.terrain()), 0.5);
  }
}

/// A sensor on the roof and one 0.8 m to its side and lower.
struct TwoSensors {
  Eigen::Isometry3d mountings[2] = {pose(0.0, 0.0, 1.75), pose(0.0, 0.8, 1.15)};
  SimulatedScan simulated[2];
  SensorScan scans[2];

  explicit TwoSensors(const Eigen::Isometry3d& T_map_base, unsigned seed) {
    for (int i = 0; i < 2; ++i) {
      simulated[i] = cast_scan(narrow_road(), {}, T_map_base, mountings[i],
                               2 * seed + static_cast<unsigned>(i));
      scans[i].points = simulated[i].view();
      scans[i].T_base_sensor = mountings[i];
    }
  }

  std::array<Score, 2> scores(const ScanResult& result) const {
    return {testing::score(result.labels, simulated[0].truth),
            testing::score(result.labels, simulated[1].truth, simulated[0].truth.size())};
  }
};

TEST(Sensors, TwoAtOnce) {
  for (const Config& config : {Config{}, Config::paper()}) {
    GroundGrid grid(config);
    for (int i = 0; i < 5; ++i) {
      const Eigen::Isometry3d T_map_base = pose(0.4 * i, 0.0, 0.0);
      const TwoSensors sensors(T_map_base, static_cast<unsigned>(i));
      for (const Score& score :
           sensors.scores(grid.process({.scans = sensors.scans, .T_map_base = T_map_base}))) {
        EXPECT_GE(score.ground_recall(), 0.985) << "scan " << i;
        EXPECT_GE(score.obstacle_recall(), 0.98) << "scan " << i;
        // The paper's filter tests every point and takes some at walls' feet for outliers.
        EXPECT_LE(score.outliers, score.ground_points / 1000) << "scan " << i;
      }
    }
  }
}

TEST(Sensors, EachMountingCounts) {
  // With the second sensor's place forgotten its points hang 0.6 m too high: the test can fail.
  TwoSensors sensors(pose(0.0, 0.0, 0.0), 1);
  sensors.scans[1].T_base_sensor = sensors.mountings[0];
  GroundGrid grid;
  const ScanResult result = grid.process({.scans = sensors.scans});
  EXPECT_LT(sensors.scores(result)[1].ground_recall(), 0.8);
}

TEST(Sensors, OneAfterAnother) {
  GroundGrid grid;
  for (int i = 0; i < 4; ++i) {
    const Eigen::Isometry3d T_map_base = pose(0.4 * i, 0.0, 0.0);
    const TwoSensors sensors(T_map_base, static_cast<unsigned>(i));
    for (int sensor = 0; sensor < 2; ++sensor) {
      const ScanResult result = grid.process(sensors.scans[sensor], T_map_base);
      const Score score = testing::score(result.labels, sensors.simulated[sensor].truth);
      EXPECT_GE(score.ground_recall(), 0.985) << "sensor " << sensor;
      EXPECT_GE(score.obstacle_recall(), 0.98) << "sensor " << sensor;
      EXPECT_EQ(score.outliers, 0U) << "sensor " << sensor;
    }
  }
}

TEST(Sensors, AReflectionIsAnOutlierForEitherSensor) {
  TwoSensors sensors(pose(0.0, 0.0, 0.0), 1);
  GroundGrid grid;
  for (int i = 0; i < 5; ++i) grid.process({.scans = sensors.scans});
  for (int i = 0; i < 2; ++i) {
    const auto height = static_cast<float>(sensors.mountings[i].translation().z());
    sensors.simulated[i].records.push_back({5.0F, -2.5F, -height - 1.5F, 0.0F, 0.0});
    sensors.scans[i].points = sensors.simulated[i].view();
  }
  const ScanResult result = grid.process({.scans = sensors.scans});
  EXPECT_EQ(result.outlier, 2U);
  EXPECT_EQ(result.labels[sensors.simulated[0].records.size() - 1], Label::outlier);
  EXPECT_EQ(result.labels.back(), Label::outlier);
}

}  // namespace
}  // namespace groundgrid
