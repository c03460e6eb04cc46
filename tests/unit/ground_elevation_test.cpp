// Paper III-D: eq. 4, 5 and 6, and the cells that are not ground.
#include "core/ground_elevation.hpp"

#include <gtest/gtest.h>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

TEST(ObservationConfidence, IsThePatchsPointsOverTheScaleFromZeroToOne) {
  const Config paper = Config::paper();  // s = 20
  EXPECT_FLOAT_EQ(observation_confidence(0.0F, paper), 0.0F);
  EXPECT_FLOAT_EQ(observation_confidence(5.0F, paper), 0.25F);  // 5 / 20
  EXPECT_FLOAT_EQ(observation_confidence(20.0F, paper), 1.0F);
  EXPECT_FLOAT_EQ(observation_confidence(50.0F, paper), 1.0F);  // 2.5, clamped
}

TEST(FuseGround, WeighsHeightsByConfidence) {
  // Eq. 5: (0.25·2 + 0.5·1) / (0.25 + 0.5) = 1 / 0.75 = 1.333333
  // Eq. 6: (0.25/2 + 0.5) / 2 = 0.3125
  const CellEstimate fused = fuse_ground({1.0F, 0.5F}, 2.0F, 0.25F);
  EXPECT_FLOAT_EQ(fused.height, 4.0F / 3.0F);
  EXPECT_FLOAT_EQ(fused.confidence, 0.3125F);
}

TEST(FuseGround, TakesTheObservationWhereNothingIsKnown) {
  // (0.5·2 + 0·7) / 0.5 = 2; (0.5/2 + 0) / 2 = 0.125
  const CellEstimate fused = fuse_ground({7.0F, 0.0F}, 2.0F, 0.5F);
  EXPECT_FLOAT_EQ(fused.height, 2.0F);
  EXPECT_FLOAT_EQ(fused.confidence, 0.125F);
}

TEST(FuseGround, KeepsTheHeightWhereNeitherHasConfidence) {
  const CellEstimate fused = fuse_ground({7.0F, 0.0F}, 2.0F, 0.0F);
  EXPECT_FLOAT_EQ(fused.height, 7.0F);
  EXPECT_FLOAT_EQ(fused.confidence, 0.0F);
}

TEST(FuseGround, RepeatedFullObservationsLeadToHalfConfidence) {
  // Eq. 6 with q = 1: c = (0.5 + c) / 2 has its fixed point at 0.5.
  CellEstimate estimate{0.0F, 0.0F};
  for (int scan = 0; scan < 40; ++scan) estimate = fuse_ground(estimate, 1.0F, 1.0F);
  EXPECT_NEAR(estimate.confidence, 0.5F, 1e-6F);
  EXPECT_NEAR(estimate.height, 1.0F, 1e-6F);
}

TEST(FuseObstacle, LowersTheGroundAndAddsALittleConfidence) {
  const CellEstimate lowered = fuse_obstacle({1.0F, 0.2F}, 0.4F);
  EXPECT_FLOAT_EQ(lowered.height, 0.4F);
  EXPECT_FLOAT_EQ(lowered.confidence, 0.3F);                             // min(0.2 + 0.1, 0.5)
  EXPECT_FLOAT_EQ(fuse_obstacle({1.0F, 0.45F}, 0.4F).confidence, 0.5F);  // min(0.55, 0.5)
  EXPECT_FLOAT_EQ(fuse_obstacle({1.0F, 0.7F}, 0.4F).confidence, 0.5F);   // min(0.8, 0.5)
}

TEST(FuseObstacle, NeverRaisesTheGround) {
  for (const float elevation : {1.0F, 1.5F}) {
    const CellEstimate kept = fuse_obstacle({1.0F, 0.2F}, elevation);
    EXPECT_FLOAT_EQ(kept.height, 1.0F);
    EXPECT_FLOAT_EQ(kept.confidence, 0.2F);
  }
}

TEST(UpdateElevation, TakesGroundObstacleAndSkippedCellsIntoTheMap) {
  Config config = metre_grid(11);
  config.min_point_fraction = 0.0;
  ElevationMap map = flat_map(config);
  PointsInCells points(map);
  points.add(2, 2, {0.1, 0.1, 0.1, 0.1, 0.1});  // flat: ground
  points.add(5, 8, {-0.4, 0.6});                // varies, below the map: an obstacle's foot
  points.add(8, 2, {0.3, 0.9});                 // varies, above the map
  const std::size_t ground = cell_index(map, 2, 2);
  const std::size_t below = cell_index(map, 5, 8);
  const std::size_t above = cell_index(map, 8, 2);
  for (const std::size_t cell : {ground, below, above}) map.confidence()[cell] = 0.25F;

  TileRunner runner(1);
  GroundCells cells(map.cells());
  cells.classify(points.grid(), map, SensorPositions{{{5.5F, 5.5F, 1.7F}}}, config, runner);
  update_elevation(points.grid(), cells, config, runner, map);

  // q = 5/20; (0.25·0.1 + 0.25·0) / 0.5 = 0.05; (0.125 + 0.25) / 2 = 0.1875
  EXPECT_NEAR(map.height()[ground], 0.05F, 1e-6F);
  EXPECT_NEAR(map.confidence()[ground], 0.1875F, 1e-6F);
  EXPECT_NEAR(map.height()[below], -0.4F, 1e-6F);
  EXPECT_NEAR(map.confidence()[below], 0.35F, 1e-6F);
  EXPECT_FLOAT_EQ(map.height()[above], 0.0F);
  EXPECT_FLOAT_EQ(map.confidence()[above], 0.25F);

  // The same scan with so many points expected that every cell is skipped changes nothing.
  config.min_point_fraction = 100.0;
  const std::vector<float> before = map.height();
  cells.classify(points.grid(), map, SensorPositions{{{5.5F, 5.5F, 1.7F}}}, config, runner);
  update_elevation(points.grid(), cells, config, runner, map);
  EXPECT_EQ(map.height(), before);
}

}  // namespace
}  // namespace groundgrid
