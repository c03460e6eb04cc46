// Once warm, process() allocates nothing.
#include <gtest/gtest.h>

#include "allocation_counter.hpp"
#include "groundgrid/ground_grid.hpp"
#include "groundgrid/terrain_layers.hpp"
#include "support/drive.hpp"
#ifndef GROUNDGRID_STD_THREAD
#include "groundgrid/tbb_executor.hpp"
#endif

namespace groundgrid {
namespace {

using testing::DriveScan;
using testing::street_drive;

std::size_t allocations_once_warm(GroundGrid grid) {
  const std::vector<DriveScan> drive = street_drive(6);
  const auto pass = [&] {
    for (const DriveScan& scan : drive) grid.process(scan.scan(), scan.T_map_base);
  };
  pass();
  const std::size_t before = testing::allocations();
  pass();
  return testing::allocations() - before;
}

TEST(Allocation, IsCounted) {
  const std::size_t before = testing::allocations();
  const std::vector<int> vector(100);
  EXPECT_EQ(testing::allocations(), before + 1);
}

TEST(Allocation, ProcessAllocatesNothingOnceWarm) {
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config{})), 0U);
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config::paper())), 0U);
  Config steps;
  steps.labels.max_step_m = 0.08;
  EXPECT_EQ(allocations_once_warm(GroundGrid(steps)), 0U);
}

/// The same rays, none of which meets anything that stands.
std::vector<DriveScan> flattened(std::vector<DriveScan> drive) {
  for (DriveScan& scan : drive)
    for (std::size_t z = 2; z < scan.points.size(); z += scan.floats_per_point)
      scan.points[z] = -1.75F;
  return drive;
}

class FourAtATime final : public Executor {
 public:
  [[nodiscard]] int concurrency() const override { return 4; }
  void run(std::size_t tiles, TileTask task) override {
    for (std::size_t tile = 0; tile < tiles; ++tile) task(tile);
  }
};

TEST(Allocation, ProcessWithAnExecutorAllocatesNothingOnceWarm) {
  FourAtATime executor;
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config{}, executor)), 0U);
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config::paper(), executor)), 0U);
}

std::size_t allocations_for_what_stands(GroundGrid grid) {
  const std::vector<DriveScan> street = street_drive(6);
  for (const DriveScan& scan : flattened(street)) grid.process(scan.scan(), scan.T_map_base);
  const std::size_t before = testing::allocations();
  for (const DriveScan& scan : street) grid.process(scan.scan(), scan.T_map_base);
  return testing::allocations() - before;
}

TEST(Allocation, ProcessAllocatesNothingForAnotherScene) {
  FourAtATime executor;
  EXPECT_EQ(allocations_for_what_stands(GroundGrid(Config{})), 0U);
  EXPECT_EQ(allocations_for_what_stands(GroundGrid(Config{}, executor)), 0U);
}

#ifndef GROUNDGRID_STD_THREAD
TEST(Allocation, ProcessInAnArenaOfTheCallerAllocatesNothingOnceWarm) {
  oneapi::tbb::task_arena arena(2);
  TbbExecutor executor(arena);
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config{}, executor)), 0U);
}

TEST(Allocation, ProcessOnTwoThreadsAllocatesNothingOnceWarm) {
  EXPECT_EQ(allocations_once_warm(GroundGrid(Config{}, 2)), 0U);
}
#endif

TEST(Allocation, CorrectionOfMotionAllocatesNothingOnceWarm) {
  const Eigen::Isometry3d begin = testing::pose(0.0, 0.0, 0.0);
  const Eigen::Isometry3d end = testing::pose(1.0, 0.0, 0.0, 5.0);
  const testing::SimulatedScan simulated =
      testing::cast_scan({}, {}, begin, end, testing::pose(0.0, 0.0, 1.75), 1);
  SensorScan scan;
  scan.points = simulated.view();
  scan.T_base_sensor = testing::pose(0.0, 0.0, 1.75);
  scan.time_end = 0.1;
  GroundGrid grid;
  const std::span<const SensorScan> scans(&scan, 1);
  grid.process({.scans = scans, .T_map_base = end, .T_map_base_begin = begin});
  const std::size_t before = testing::allocations();
  grid.process({.scans = scans, .T_map_base = end, .T_map_base_begin = begin});
  EXPECT_EQ(testing::allocations() - before, 0U);
}

TEST(Allocation, LayersOfTheTerrainAllocateNothingOnceWarm) {
  const std::vector<DriveScan> drive = street_drive(2);
  GroundGrid grid;
  TerrainLayers layers;
  const auto pass = [&] {
    std::size_t allocations = 0;
    for (const DriveScan& step : drive) {
      const SensorScan scan = step.scan();
      const ScanResult result = grid.process(scan, step.T_map_base);
      const std::size_t before = testing::allocations();
      layers.update(grid.terrain());
      layers.update(grid.terrain(), std::span(&scan, 1), step.T_map_base, result.labels);
      allocations += testing::allocations() - before;
    }
    return allocations;
  };
  EXPECT_GT(pass(), 0U);
  EXPECT_EQ(pass(), 0U);
}

TEST(Allocation, ResetKeepsTheBuffers) {
  const std::vector<DriveScan> drive = street_drive(1);
  Config config;
  config.vehicle.sensor_height_m = 1.75;  // an estimate of the height may allocate
  GroundGrid grid(config);
  grid.process(drive[0].scan());
  const std::size_t before = testing::allocations();
  grid.reset();
  grid.process(drive[0].scan());
  EXPECT_EQ(testing::allocations() - before, 0U);
}

}  // namespace
}  // namespace groundgrid
