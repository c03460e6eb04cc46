// Scans that are skewed by the vehicle's own motion.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>

#include "groundgrid/ground_grid.hpp"
#include "support/ray_caster.hpp"

namespace groundgrid {
namespace {

using testing::cast_scan;
using testing::pose;
using testing::Scene;
using testing::Score;
using testing::SimulatedScan;
using testing::SpinningSensor;

const Eigen::Isometry3d kOnRoof = pose(0.0, 0.0, 1.75);

Scene parked_road() {
  Scene scene;
  scene.boxes = {{{12.0, -8.0, -1.0}, {16.0, -6.0, 1.5}}, {{-40.0, 12.0, -1.0}, {60.0, 13.0, 4.0}}};
  return scene;
}

/// The vehicle at the time of a scan's begin: 10 m/s, turning left by 30°/s, nodding over speed
/// bumps.
Eigen::Isometry3d pose_at(double seconds) {
  const double yaw = 30.0 * seconds;
  const double turned = yaw * std::numbers::pi / 180.0;
  const double radius = 10.0 / (30.0 * std::numbers::pi / 180.0);
  Eigen::Isometry3d T_map_base =
      pose(radius * std::sin(turned), radius * (1.0 - std::cos(turned)), 0.0, yaw);
  const double pitch = 0.05 * std::sin(seconds * std::numbers::pi / 0.2);
  T_map_base.rotate(Eigen::AngleAxisd(pitch, Eigen::Vector3d::UnitY()));
  return T_map_base;
}

ScanRequest request(std::span<const SensorScan> scans, const Eigen::Isometry3d& begin,
                    const Eigen::Isometry3d& end, bool corrected) {
  ScanRequest request{.scans = scans, .T_map_base = end};
  if (corrected) request.T_map_base_begin = begin;
  return request;
}

struct Errors {
  double ground = 0.0;    ///< Share of ground points not called ground.
  double obstacle = 0.0;  ///< Share of obstacle points not called obstacle.
};

/// Two sensors that look into opposite directions at any time, as their scans are skewed: what
/// one sees at the begin the other sees in the middle of the scan.
Errors drive(bool corrected) {
  GroundGrid grid;
  Score sum;
  for (int i = 0; i < 6; ++i) {
    const Eigen::Isometry3d begin = pose_at(0.1 * i);
    const Eigen::Isometry3d end = pose_at(0.1 * (i + 1));
    SimulatedScan simulated[2];
    SensorScan scans[2];
    std::size_t first = 0;
    for (int sensor = 0; sensor < 2; ++sensor) {
      SpinningSensor spinning;
      spinning.first_azimuth_deg = 180.0 * sensor;
      simulated[sensor] = cast_scan(parked_road(), spinning, begin, end, kOnRoof,
                                    static_cast<unsigned>(2 * i + sensor));
      scans[sensor].points = simulated[sensor].view();
      scans[sensor].T_base_sensor = kOnRoof;
      scans[sensor].time_end = 0.1;
    }
    const ScanResult result = grid.process(request(scans, begin, end, corrected));
    for (const SimulatedScan& scan : simulated) {
      sum.add(testing::score(result.labels, scan.truth, first));
      first += scan.truth.size();
    }
  }
  return {1.0 - sum.ground_recall(), 1.0 - sum.obstacle_recall()};
}

TEST(Motion, CorrectionGivesTheRightLabels) {
  const Errors corrected = drive(true);
  const Errors skewed = drive(false);
  EXPECT_LT(corrected.ground, 0.01);
  EXPECT_LT(corrected.obstacle, 0.02);
  // Without correction the same scans are measurably worse: the test can fail.
  EXPECT_GT(skewed.ground, 0.05);
}

TEST(Motion, CorrectionGivesTheRightTerrain) {
  const auto worst_height = [](bool corrected) {
    const Eigen::Isometry3d begin = pose_at(0.0);
    const Eigen::Isometry3d end = pose_at(0.1);
    const SimulatedScan simulated = cast_scan({}, {}, begin, end, kOnRoof, 1);
    SensorScan scan;
    scan.points = simulated.view();
    scan.T_base_sensor = kOnRoof;
    scan.time_end = 0.1;
    const std::span<const SensorScan> scans(&scan, 1);
    GroundGrid grid;
    grid.process(request(scans, begin, end, corrected));
    const TerrainView terrain = grid.terrain();
    double worst = 0.0;
    for (int row = 0; row < terrain.size; ++row)
      for (int column = 0; column < terrain.size; ++column)
        if (const TerrainCell cell = terrain.cell(column, row); cell.confidence > 0.1F)
          worst = std::max(worst, std::abs(cell.height));
    return worst;
  };
  EXPECT_LT(worst_height(true), 0.05);
  EXPECT_GT(worst_height(false), 0.15);
}

TEST(Motion, ObstaclesStayObstacles) {
  const Eigen::Isometry3d begin = pose_at(0.0);
  const Eigen::Isometry3d end = pose_at(0.1);
  const SimulatedScan simulated = cast_scan(parked_road(), {}, begin, end, kOnRoof, 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = kOnRoof;
  scan.time_end = 0.1;
  GroundGrid grid;
  const Score score =
      testing::score(grid.process(request({&scan, 1}, begin, end, true)).labels, simulated.truth);
  EXPECT_GE(score.obstacle_recall(), 0.98);
}

TEST(Motion, AVehicleAtRestGivesTheSameWithAndWithout) {
  const Eigen::Isometry3d rest = pose(0.0, 0.0, 0.0);
  const Eigen::Isometry3d same = rest;
  const SimulatedScan simulated = cast_scan(parked_road(), {}, rest, kOnRoof, 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = kOnRoof;
  scan.time_end = 0.1;
  GroundGrid with;
  GroundGrid without;
  const ScanResult a = with.process(request({&scan, 1}, rest, same, true));
  const ScanResult b = without.process(scan, rest);
  EXPECT_TRUE(std::equal(a.labels.begin(), a.labels.end(), b.labels.begin(), b.labels.end()));
}

}  // namespace
}  // namespace groundgrid
