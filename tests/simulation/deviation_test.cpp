// The standard deviations of the map's heights against the true heights of simulated drives.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <vector>

#include "core/map/cell_statistics.hpp"
#include "evaluation/cell_distance.hpp"
#include "evaluation/deviation_calibration.hpp"
#include "groundgrid/ground_grid.hpp"
#include "simulation/drive.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene.hpp"
#include "simulation/sensors.hpp"

namespace groundgrid::simulation {
namespace {

using evaluation::DeviationCalibration;
using evaluation::JudgedHeight;

constexpr std::size_t kScans = 20;
constexpr std::size_t kEvery = 5;

/// Cells of the map by what is known of them.
struct Judged {
  std::vector<JudgedHeight> known{};    ///< Ground, seen in this scan or remembered.
  std::vector<JudgedHeight> near{};     ///< Others, at most 2 m from a point of this scan.
  std::vector<JudgedHeight> farther{};  ///< Others, at most 10 m from one.
};

void judge(const GroundGrid& ground_grid, const Terrain& terrain, Judged& judged) {
  const TerrainView view = ground_grid.terrain();
  const std::span<const float> deviation = ground_grid.standard_deviation();
  std::vector<std::uint8_t> seen(deviation.size());
  for (std::size_t cell = 0; cell < seen.size(); ++cell)
    seen[cell] = view.statistics[cell].count > 0 ? 1 : 0;
  const std::vector<float> from_seen_m =
      evaluation::distance_to(seen, {view.size, view.size, view.resolution_m, view.resolution_m});
  for (int row = 0; row < view.size; ++row) {
    for (int column = 0; column < view.size; ++column) {
      const auto cell = static_cast<std::size_t>(row * view.size + column);
      const double truth = terrain.height({view.min_x_m + (column + 0.5) * view.resolution_m,
                                           view.min_y_m + (row + 0.5) * view.resolution_m});
      const JudgedHeight height{view.cell(column, row).height - truth,
                                static_cast<double>(deviation[cell])};
      if (view.confidence[cell] >= 0.05F)
        judged.known.push_back(height);
      else if (from_seen_m[cell] <= 2.0F)
        judged.near.push_back(height);
      else if (from_seen_m[cell] <= 10.0F)
        judged.farther.push_back(height);
    }
  }
}

Judged drive_through(const std::string& scene_name, const Config& config) {
  TileRunner runner(0);
  const double length = kScans * scene_speed_mps(scene_name) / 10.0;
  const Scene scene = make_scene(scene_name, 5, length);
  const Terrain terrain(*scene.path, length, scene.ground, runner);
  const Drive drive(scene, terrain, 5);
  World world(scene, terrain);
  Scanner scanner(world, drive, make_sensor("hdl-64e"), Motion::corrected, 5, runner);
  GroundGrid ground_grid(config);
  Judged judged;
  for (std::size_t i = 0; i < kScans; ++i) {
    const Scan scan = scanner.scan(i);
    SensorScan sensor_scan;
    sensor_scan.points = PointView::from_floats(scan.points.data(), scan.labels.size(), 4);
    ground_grid.process(sensor_scan, scan.T_world_sensor);
    if (i % kEvery == kEvery - 1) judge(ground_grid, terrain, judged);
  }
  return judged;
}

class Deviation : public ::testing::TestWithParam<const char*> {};

TEST_P(Deviation, HoldsTwoThirdsOfTheTrueHeightsAndTwiceItNearlyAll) {
  const Judged judged = drive_through(GetParam(), Config{});
  // Measured: 0.70 (off-road, grass over the soil) to 0.94 and 0.92 to 0.99.
  const DeviationCalibration known = evaluation::calibrate(judged.known);
  EXPECT_GT(known.cells, 30'000U);
  EXPECT_GE(known.within_one, 0.68);
  EXPECT_GE(known.within_two, 0.91);
  // 0.76 (village, steps behind walls) to 0.88 and 0.87 to 0.97.
  const DeviationCalibration near = evaluation::calibrate(judged.near);
  EXPECT_GE(near.within_one, 0.75);
  EXPECT_GE(near.within_two, 0.86);
  // 0.86 to 0.92 and 0.98 to 0.99.
  const DeviationCalibration farther = evaluation::calibrate(judged.farther);
  EXPECT_GE(farther.within_one, 0.85);
  EXPECT_GE(farther.within_two, 0.97);
}

TEST(DeviationOfThePapersPreset, HoldsTooAlthoughNoPlanesFillItsMap) {
  const Judged judged = drive_through("motorway", Config::paper());
  const DeviationCalibration known = evaluation::calibrate(judged.known);
  EXPECT_GE(known.within_one, 0.68);
  EXPECT_GT(known.median_m, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Simulated, Deviation,
                         ::testing::Values("urban", "hill", "motorway", "village", "offroad"));

}  // namespace
}  // namespace groundgrid::simulation
