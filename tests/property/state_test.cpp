// What an object keeps from scan to scan, and when it forgets it.
#include <gtest/gtest.h>

#include <cmath>

#include "groundgrid/ground_grid.hpp"
#include "support/drive.hpp"

namespace groundgrid {
namespace {

using testing::DriveResult;
using testing::DriveScan;
using testing::pose;
using testing::run_drive;
using testing::same_bits;
using testing::street_drive;

TEST(State, ResetEqualsAFreshObject) {
  const std::vector<DriveScan> drive = street_drive(3);
  std::vector<DriveScan> elsewhere = street_drive(2);
  for (DriveScan& scan : elsewhere) {
    // Near enough for the way back to be no jump, which would start the map anew by itself.
    scan.T_map_base = pose(7.7, -3.3, 0.5, 30.0) * scan.T_map_base;
    for (std::size_t i = 2; i < scan.points.size(); i += 3) scan.points[i] += 0.5F;
  }
  GroundGrid grid;
  run_drive(grid, elsewhere);
  grid.reset();
  EXPECT_EQ(grid.terrain().size, 0);
  EXPECT_FALSE(grid.process(ScanRequest{}).sensor_height_m.has_value());
  grid.reset();
  EXPECT_TRUE(same_bits(run_drive(grid, drive), run_drive(Config{}, drive)));
}

TEST(State, TheMapIsKeptFromScanToScan) {
  const std::vector<DriveScan> drive = street_drive(2);
  GroundGrid grid;
  run_drive(grid, drive);
  GroundGrid forgetful;
  run_drive(forgetful, {drive[1]});
  const auto confident = [](const GroundGrid& of) {
    std::size_t cells = 0;
    for (const float confidence : of.terrain().confidence) cells += confidence > 0.3F ? 1 : 0;
    return cells;
  };
  EXPECT_GT(confident(grid), confident(forgetful));
}

TEST(State, ConfigIsKeptAsGiven) {
  Config config;
  config.map.resolution_m = 0.5;
  config.map.extent_m = 50.0;
  const GroundGrid grid(config);
  EXPECT_EQ(grid.config().map.resolution_m, 0.5);
  GroundGrid working(config);
  working.process(street_drive(1)[0].scan());
  EXPECT_EQ(working.terrain().resolution_m, 0.5);
  EXPECT_NEAR(working.terrain().size * 0.5, 50.0, 0.51);
}

TEST(State, APoseJumpRestartsTheMapAndSaysSo) {
  const std::vector<DriveScan> drive = street_drive(2);
  GroundGrid grid;
  EXPECT_FALSE(grid.process(drive[0].scan(), drive[0].T_map_base).map_restarted);
  EXPECT_FALSE(grid.process(drive[1].scan(), drive[1].T_map_base).map_restarted);
  const Eigen::Isometry3d far = pose(500.0, 0.0, 1.75);
  const ScanResult result = grid.process(drive[0].scan(), far);
  EXPECT_TRUE(result.map_restarted);
  const std::vector<Label> labels(result.labels.begin(), result.labels.end());

  // What follows is as if the drive had begun there, on the same lattice.
  Config anchored;
  const Eigen::Vector3d first = drive[0].T_map_base.translation();
  anchored.map.anchor_m = {first.x(), first.y()};
  GroundGrid fresh(anchored);
  const ScanResult expected = fresh.process(drive[0].scan(), far);
  EXPECT_TRUE(std::equal(labels.begin(), labels.end(), expected.labels.begin()));
  EXPECT_FALSE(grid.process(drive[0].scan(), far).map_restarted);
}

TEST(State, MovesUpToTheJumpAreNoJumps) {
  const std::vector<DriveScan> drive = street_drive(1);
  GroundGrid grid;
  grid.process(drive[0].scan(), pose(0.0, 0.0, 0.0));
  EXPECT_FALSE(grid.process(drive[0].scan(), pose(19.9, 0.0, 0.0)).map_restarted);
  EXPECT_FALSE(grid.process(drive[0].scan(), pose(19.9, 19.9, 0.0)).map_restarted);
  EXPECT_TRUE(grid.process(drive[0].scan(), pose(19.9, 19.9, 20.1)).map_restarted);
}

/// The share of the labels of the last scan that a grid of its own gives as well.
double same_as_alone(const ScanResult& result, const DriveScan& scan,
                     const Eigen::Isometry3d& T_map_base) {
  GroundGrid alone;
  const ScanResult expected = alone.process(scan.scan(), T_map_base);
  std::size_t same = 0;
  for (std::size_t i = 0; i < result.labels.size(); ++i)
    same += result.labels[i] == expected.labels[i] ? 1U : 0U;
  return static_cast<double>(same) / static_cast<double>(result.labels.size());
}

TEST(State, AStepInHeightRestartsTheMapAtOnce) {
  const std::vector<DriveScan> drive = street_drive(6);
  for (const double step : {3.5, 0.4, -0.4, -1.0, -3.5}) {
    SCOPED_TRACE(step);
    GroundGrid grid;
    for (std::size_t i = 0; i < 5; ++i)
      EXPECT_FALSE(grid.process(drive[i].scan(), drive[i].T_map_base).map_restarted) << i;
    Eigen::Isometry3d moved = drive[5].T_map_base;
    moved.translation().z() += step;
    const ScanResult result = grid.process(drive[5].scan(), moved);
    EXPECT_TRUE(result.map_restarted);
    EXPECT_GT(same_as_alone(result, drive[5], moved), 0.99);
    EXPECT_FALSE(grid.process(drive[5].scan(), moved).map_restarted);
  }
}

// The pose cannot know: a floor that lies lower than the one before, below a pose that stays.
TEST(State, GroundAtAnotherHeightRestartsTheMap) {
  const std::vector<DriveScan> drive = street_drive(5);
  GroundGrid grid;
  for (const DriveScan& scan : drive) grid.process(scan.scan(), scan.T_map_base);
  DriveScan lowered = drive[4];
  for (std::size_t i = 2; i < lowered.points.size(); i += 3) lowered.points[i] -= 0.6F;
  EXPECT_TRUE(grid.process(lowered.scan(), lowered.T_map_base).map_restarted);
}

TEST(State, TheEstimatedSensorHeightIsReportedAndKeptUntilReset) {
  const DriveScan first = street_drive(1)[0];
  DriveScan raised = first;  // as if the sensor had been lifted by half a metre
  for (std::size_t i = 2; i < raised.points.size(); i += 3) raised.points[i] -= 0.5F;
  GroundGrid grid;
  const ScanResult estimated = grid.process(first.scan());
  EXPECT_TRUE(estimated.sensor_height_estimated);
  EXPECT_NEAR(estimated.sensor_height_m.value(), 1.75, 0.05);
  const double height = estimated.sensor_height_m.value();
  const ScanResult kept = grid.process(raised.scan());
  EXPECT_TRUE(kept.sensor_height_estimated);
  EXPECT_EQ(kept.sensor_height_m, height);
  grid.process(raised.scan(), pose(500.0, 0.0, 0.0));
  EXPECT_EQ(grid.process(raised.scan(), pose(500.0, 0.0, 0.0)).sensor_height_m, height)
      << "a restart of the map is no reset";
  grid.reset();
  EXPECT_NEAR(grid.process(raised.scan()).sensor_height_m.value(), 2.25, 0.05);
}

TEST(State, AGivenSensorHeightIsTaken) {
  const DriveScan street = street_drive(1)[0];
  Config config;
  config.vehicle.sensor_height_m = 1.7;
  GroundGrid grid(config);
  const ScanResult by_config = grid.process(street.scan());
  EXPECT_FALSE(by_config.sensor_height_estimated);
  EXPECT_EQ(by_config.sensor_height_m, 1.7);

  SensorScan mounted = street.scan();
  mounted.T_base_sensor = pose(0.5, 0.0, 1.75);
  GroundGrid by_mounting;
  const ScanResult result = by_mounting.process(mounted);
  EXPECT_FALSE(result.sensor_height_estimated);
  EXPECT_EQ(result.sensor_height_m, 1.75);
}

TEST(State, AScanWithoutGroundLeavesTheEstimateToTheNext) {
  GroundGrid grid;
  const std::vector<float> sky{10.0F, 0.0F, 5.0F, 0.0F, 10.0F, 5.0F};
  SensorScan nothing;
  nothing.points = PointView::from_floats(sky.data(), 2, 3);
  const ScanResult unknown = grid.process(nothing);
  EXPECT_FALSE(unknown.sensor_height_estimated);
  EXPECT_FALSE(unknown.sensor_height_m.has_value());
  const ScanResult result = grid.process(street_drive(1)[0].scan());
  EXPECT_TRUE(result.sensor_height_estimated);
  EXPECT_NEAR(result.sensor_height_m.value(), 1.75, 0.05);
  EXPECT_FALSE(result.map_restarted);
}

TEST(State, ACallWithoutSensorsLeavesTheStartToTheFirstScan) {
  const std::vector<DriveScan> drive = street_drive(1);
  GroundGrid grid;
  grid.process({.T_map_base = drive[0].T_map_base});
  EXPECT_TRUE(same_bits(run_drive(grid, drive), run_drive(Config{}, drive)));
}

TEST(State, AnObjectMayBeMoved) {
  const std::vector<DriveScan> drive = street_drive(2);
  GroundGrid first;
  run_drive(first, {drive[0]});
  GroundGrid second = std::move(first);
  GroundGrid expected;
  run_drive(expected, {drive[0]});
  EXPECT_TRUE(same_bits(run_drive(second, {drive[1]}), run_drive(expected, {drive[1]})));
}

}  // namespace
}  // namespace groundgrid
