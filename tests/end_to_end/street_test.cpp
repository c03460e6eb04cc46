// Simple worlds with exact truth: labels, heights and terrain must be right.
#include <gtest/gtest.h>

#include <cmath>

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
using testing::Truth;

const Eigen::Isometry3d kRoofMount = pose(0.0, 0.0, 1.75);

/// A van 10 m ahead and a wall on the left.
Scene road() {
  Scene scene;
  scene.boxes = {{{10.0, -1.0, -1.0}, {14.0, 1.0, 2.0}}, {{-30.0, 8.0, -1.0}, {30.0, 9.0, 4.0}}};
  return scene;
}

/// Drives `scans` steps of half a metre and scores the last scan.
Score drive(GroundGrid& grid, const Scene& scene, const SpinningSensor& sensor,
            const Eigen::Isometry3d& T_base_sensor, int scans = 4) {
  Score last;
  for (int i = 0; i < scans; ++i) {
    const double x = 0.5 * i;
    Eigen::Isometry3d T_map_base = pose(x, 0.0, scene.slope_x * x);
    T_map_base.rotate(Eigen::AngleAxisd(-std::atan(scene.slope_x), Eigen::Vector3d::UnitY()));
    const SimulatedScan simulated =
        cast_scan(scene, sensor, T_map_base, T_base_sensor, static_cast<unsigned>(i));
    SensorScan scan;
    scan.points = simulated.view();
    scan.T_base_sensor = T_base_sensor;
    last = testing::score(grid.process(scan, T_map_base).labels, simulated.truth);
  }
  return last;
}

void expect_right(const Score& score, double ground = 0.99, double obstacle = 0.98) {
  EXPECT_GT(score.ground_points, 1000U);
  EXPECT_GT(score.obstacle_points, 200U);
  EXPECT_GE(score.ground_recall(), ground);
  EXPECT_GE(score.obstacle_recall(), obstacle);
  // The paper's filter tests every point and takes some at walls' feet for outliers.
  EXPECT_LE(static_cast<double>(score.outliers), 0.01 * static_cast<double>(score.ground_points));
}

class BothPresets : public ::testing::TestWithParam<bool> {
 protected:
  static Config config() { return GetParam() ? Config::paper() : Config{}; }
};
INSTANTIATE_TEST_SUITE_P(Street, BothPresets, ::testing::Bool(), [](const auto& preset) {
  return preset.param ? std::string("paper") : std::string("standard");
});

TEST_P(BothPresets, FlatRoadWithABox) {
  GroundGrid grid(config());
  expect_right(drive(grid, road(), {}, kRoofMount));
}

TEST_P(BothPresets, FirstScanAlone) {
  GroundGrid grid(config());
  expect_right(drive(grid, road(), {}, kRoofMount, 1));
}

TEST_P(BothPresets, ARoofBelowTheSensorIsNoGround) {
  Scene scene = road();
  scene.boxes.push_back({{4.0, 2.0, -1.0}, {8.0, 4.0, 1.4}});
  GroundGrid grid(config());
  expect_right(drive(grid, scene, {}, kRoofMount), 0.98);
}

TEST_P(BothPresets, KerbAndPavementAreGround) {
  Scene scene = road();
  scene.boxes.push_back({{-100.0, 4.0, -1.0}, {100.0, 8.0, 0.12}, true});
  GroundGrid grid(config());
  expect_right(drive(grid, scene, {}, kRoofMount), 0.97);
}

/// Ground points of a street with a kerb of 0.12 m at y = 4 m, by where they are.
struct KerbLabels {
  std::size_t face = 0, face_obstacle = 0;
  std::size_t elsewhere = 0, elsewhere_obstacle = 0;

  [[nodiscard]] double face_share() const {
    return static_cast<double>(face_obstacle) / static_cast<double>(face);
  }
  [[nodiscard]] double elsewhere_share() const {
    return static_cast<double>(elsewhere_obstacle) / static_cast<double>(elsewhere);
  }
};

KerbLabels kerb_labels(const Config& config) {
  Scene scene = road();
  scene.boxes.push_back({{-100.0, 4.0, -1.0}, {100.0, 8.0, 0.12}, true});
  const SpinningSensor sensor{.beams = 64, .azimuths = 2000};
  const SimulatedScan simulated =
      cast_scan(scene, sensor, Eigen::Isometry3d::Identity(), kRoofMount, 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = kRoofMount;
  GroundGrid grid(config);
  const ScanResult result = grid.process(scan);
  KerbLabels labels;
  for (std::size_t i = 0; i < simulated.truth.size(); ++i) {
    const auto& p = simulated.records[i];
    // Farther off the beams of this sensor leave gaps of several cells.
    if (simulated.truth[i] != Truth::ground || std::hypot(p.x, p.y) > 15.0F) continue;
    const double z = static_cast<double>(p.z) + 1.75;
    const bool obstacle = result.labels[i] == Label::obstacle;
    if (std::abs(p.y - 4.0F) < 0.03F && z > 0.05) {
      ++labels.face;
      labels.face_obstacle += obstacle ? 1 : 0;
    } else if (std::abs(p.y - 4.0F) > 0.4F) {
      ++labels.elsewhere;
      labels.elsewhere_obstacle += obstacle ? 1 : 0;
    }
  }
  return labels;
}

TEST(Street, AKerbHigherThanTheGreatestStepIsAnObstacle) {
  Config config;
  config.labels.max_step_m = 0.08;
  const KerbLabels labels = kerb_labels(config);
  EXPECT_GT(labels.face, 300U);
  EXPECT_GT(labels.elsewhere, 20000U);
  EXPECT_GT(labels.face_share(), 0.9);
  EXPECT_LT(labels.elsewhere_share(), 0.005);
}

TEST(Street, ALowerOneIsGround) {
  Config config;
  config.labels.max_step_m = 0.14;
  EXPECT_LT(kerb_labels(config).face_share(), 0.03);
  config.labels.max_step_m = 0.0;
  EXPECT_LT(kerb_labels(config).face_share(), 0.03);
}

TEST(Street, ARoadThatRisesThirtyPercentHasNoStep) {
  Scene scene;
  scene.slope_x = 0.3;
  scene.boxes = {{{10.0, -1.0, -1.0}, {14.0, 1.0, 6.0}}};
  Config config;
  GroundGrid without(config);
  config.labels.max_step_m = 0.05;
  GroundGrid with_steps(config);
  const double recall = drive(with_steps, scene, {}, kRoofMount).ground_recall();
  EXPECT_GT(recall, 0.98);
  EXPECT_NEAR(recall, drive(without, scene, {}, kRoofMount).ground_recall(), 0.003);
}

TEST_P(BothPresets, SlopeOfTenPercent) {
  Scene scene;
  scene.slope_x = 0.1;
  scene.boxes = {{{10.0, -1.0, -1.0}, {14.0, 1.0, 2.7}}, {{-30.0, 8.0, -9.0}, {30.0, 9.0, 9.0}}};
  GroundGrid grid(config());
  expect_right(drive(grid, scene, {}, kRoofMount), 0.98);
}

TEST_P(BothPresets, SensorAtFortyCentimetres) {
  SpinningSensor sensor;
  sensor.lowest_deg = -15.0;
  sensor.highest_deg = 15.0;
  GroundGrid grid(config());
  expect_right(drive(grid, road(), sensor, pose(0.0, 0.0, 0.4)), 0.98);
}

TEST_P(BothPresets, SixteenBeams) {
  SpinningSensor sensor;
  sensor.beams = 16;
  sensor.lowest_deg = -15.0;
  sensor.highest_deg = 15.0;
  sensor.azimuths = 1800;
  GroundGrid grid(config());
  expect_right(drive(grid, road(), sensor, kRoofMount), 0.98, 0.95);
}

TEST(Street, HeightsAreAboveTheRoad) {
  const SimulatedScan simulated =
      cast_scan(road(), {}, Eigen::Isometry3d::Identity(), kRoofMount, 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = kRoofMount;
  GroundGrid grid;
  const ScanResult result = grid.process(scan);
  std::size_t within = 0;
  for (std::size_t i = 0; i < simulated.truth.size(); ++i) {
    const double truth = static_cast<double>(simulated.records[i].z) + 1.75;
    if (std::abs(static_cast<double>(result.height_above_ground[i]) - truth) < 0.1) ++within;
  }
  EXPECT_GT(static_cast<double>(within), 0.99 * static_cast<double>(simulated.truth.size()));
}

TEST(Street, TerrainIsFlatWhereTheRoadIs) {
  GroundGrid grid;
  drive(grid, road(), {}, kRoofMount);
  const TerrainView terrain = grid.terrain();
  double worst = 0.0;
  int confident = 0;
  for (int row = 0; row < terrain.size; ++row)
    for (int column = 0; column < terrain.size; ++column) {
      const TerrainCell cell = terrain.cell(column, row);
      if (cell.confidence < 0.2F) continue;
      ++confident;
      worst = std::max(worst, std::abs(cell.height));
    }
  EXPECT_GT(confident, 300);
  EXPECT_LT(worst, 0.1);
}

TEST(Street, AReflectionBelowTheRoadIsAnOutlier) {
  const SimulatedScan simulated =
      cast_scan(road(), {}, Eigen::Isometry3d::Identity(), kRoofMount, 1);
  for (const Config& config : {Config{}, Config::paper()}) {
    GroundGrid grid(config);
    SensorScan scan;
    scan.points = simulated.view();
    scan.T_base_sensor = kRoofMount;
    for (int i = 0; i < 5; ++i) grid.process(scan);
    SimulatedScan reflected = simulated;
    reflected.records.push_back({6.0F, -2.0F, -1.75F - 1.5F, 0.0F, 0.0});
    scan.points = reflected.view();
    const ScanResult result = grid.process(scan);
    EXPECT_EQ(result.labels.back(), Label::outlier);
    EXPECT_EQ(result.outlier, 1U);
    EXPECT_NEAR(result.height_above_ground.back(), -1.5F, 0.1F);
  }
}

TEST(Street, SingleScanWithoutPoseAndMountingFindsItsHeight) {
  for (const double height : {0.6, 1.2, 1.73, 2.4}) {
    const SimulatedScan simulated =
        cast_scan(road(), {}, Eigen::Isometry3d::Identity(), pose(0.0, 0.0, height), 1);
    SensorScan scan;
    scan.points = simulated.view();
    GroundGrid grid;
    const ScanResult result = grid.process(scan);
    EXPECT_TRUE(result.sensor_height_estimated);
    EXPECT_NEAR(result.sensor_height_m.value(), height, 0.05);
    expect_right(testing::score(result.labels, simulated.truth));
  }
}

TEST(Street, TheOwnVehicleAndNearPointsAreUnknown) {
  Scene scene = road();
  scene.boxes.push_back({{1.0, -0.8, 0.3}, {2.0, 0.8, 0.9}});  // the own bonnet
  const SimulatedScan simulated =
      cast_scan(scene, {}, Eigen::Isometry3d::Identity(), kRoofMount, 1);
  Config config;
  config.vehicle.ego_vehicle_box_m = {0.9, 2.1, -0.9, 0.9, 0.2, 1.0};
  config.vehicle.min_range_m = 5.0;
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = kRoofMount;
  GroundGrid grid(config);
  const ScanResult result = grid.process(scan);
  std::size_t on_vehicle = 0;
  for (std::size_t i = 0; i < simulated.records.size(); ++i) {
    const auto& p = simulated.records[i];
    const bool near = p.x * p.x + p.y * p.y + p.z * p.z < 25.0F;
    ASSERT_EQ(result.labels[i] == Label::unknown, near) << p.x << ' ' << p.y << ' ' << p.z;
  }
  config.vehicle.min_range_m = 0.0;
  GroundGrid with_box(config);
  const ScanResult boxed = with_box.process(scan);
  for (std::size_t i = 0; i < simulated.records.size(); ++i) {
    const auto& p = simulated.records[i];
    const bool inside = p.x > 0.95F && p.x < 2.05F && std::abs(p.y) < 0.85F && p.z > -1.5F;
    if (!inside) continue;
    ++on_vehicle;
    ASSERT_EQ(boxed.labels[i], Label::unknown);
  }
  EXPECT_GT(on_vehicle, 100U);
}

}  // namespace
}  // namespace groundgrid
