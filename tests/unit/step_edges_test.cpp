// Steps of the ground as obstacles, on cells of one metre.
#include "core/stages/step_edges.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <utility>
#include <vector>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

constexpr int kSize = 21;
// Nearer to the border of what was seen a step has fewer cells to show itself in.
constexpr int kBorder = 4;
constexpr int kInner = kSize - 2 * kBorder;

class StepEdgesOnGround : public ::testing::Test {
 protected:
  StepEdgesOnGround()
      : config_(metre_grid(kSize)), map_(flat_map(config_)), points_(std::in_place, map_) {
    config_.labels.max_step_m = 0.1;
  }

  /// Six points at the same height in every cell from `first` to `last` column.
  void add_ground(int first, int last, const std::function<double(int, int)>& height) {
    for (int row = 0; row < kSize; ++row) {
      for (int column = first; column <= last; ++column) {
        const double z = height(column, row);
        map_.height()[cell_index(map_, column, row)] = static_cast<float>(z);
        points_->add(column, row, {z, z, z, z, z, z});
      }
    }
  }

  /// Half of the points of each cell of a column on the lower, half on the upper side of a step.
  void add_step(int column, double low, double high) {
    for (int row = 0; row < kSize; ++row) {
      map_.height()[cell_index(map_, column, row)] = static_cast<float>(low);
      points_->add(column, row, {low, low, high, high});
    }
  }

  /// Height up to which the points of a cell are ground; 0.5 m above the map unless lowered.
  float ground_up_to(int column, int row, int threads = 2) {
    TileRunner runner(threads);
    std::vector<CellLimit> limits;
    for (const float map_height : map_.height()) limits.push_back({map_height, 0.5F});
    edges_.lower_limits(points_->bins(), points_->grid(), config_, runner, limits);
    const CellLimit limit = limits[cell_index(map_, column, row)];
    return limit.level + limit.threshold;
  }

  /// Cells, none at the border, whose limit is not 0.5 m above the map.
  int lowered_cells() {
    int lowered = 0;
    for (int row = kBorder; row < kSize - kBorder; ++row)
      for (int column = kBorder; column < kSize - kBorder; ++column)
        if (points_->grid().is_occupied[cell_index(map_, column, row)] != 0 &&
            ground_up_to(column, row) < map_.height()[cell_index(map_, column, row)] + 0.499F)
          ++lowered;
    return lowered;
  }

  Config config_;
  ElevationMap map_;
  std::optional<PointsInCells> points_;
  StepEdges edges_{map_};
};

double level_ground(int /*column*/, int /*row*/) { return 0.0; }

TEST_F(StepEdgesOnGround, InAStepsCellWhatIsHalfTheLimitAboveItsFootIsNoGround) {
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.15);
  add_ground(11, 20, [](int, int) { return 0.15; });
  EXPECT_NEAR(ground_up_to(10, 10), 0.05F, 1e-6F);
  EXPECT_NEAR(ground_up_to(9, 10), 0.5F, 1e-6F);    // the road before it
  EXPECT_NEAR(ground_up_to(11, 10), 0.65F, 1e-6F);  // the pavement behind it
  EXPECT_EQ(lowered_cells(), kInner);
}

TEST_F(StepEdgesOnGround, ASteepFallIsAStepToo) {
  add_ground(0, 9, [](int, int) { return 0.15; });
  add_step(10, 0.0, 0.15);
  add_ground(11, 20, level_ground);
  EXPECT_NEAR(ground_up_to(10, 10), 0.05F, 1e-6F);
  EXPECT_EQ(lowered_cells(), kInner);
}

TEST_F(StepEdgesOnGround, OnlyAStepHigherThanTheLimitByMoreThanChanceCounts) {
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.15);
  add_ground(11, 20, [](int, int) { return 0.15; });
  // Each side is three cells of at least 1e-4 m²: sqrt(2 · 1e-4 / 3) = 0.00816 m may be chance.
  config_.labels.max_step_m = 0.1417;
  EXPECT_EQ(lowered_cells(), kInner);
  config_.labels.max_step_m = 0.1420;
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, AlongTheEdgeBetweenTwoCellsBothAreLowered) {
  add_ground(0, 9, level_ground);
  add_ground(10, 20, [](int, int) { return 0.15; });
  EXPECT_NEAR(ground_up_to(9, 10), 0.05F, 1e-6F);   // the face
  EXPECT_NEAR(ground_up_to(10, 10), 0.05F, 1e-6F);  // the strip at the edge
  EXPECT_NEAR(ground_up_to(11, 10), 0.65F, 1e-6F);
  EXPECT_EQ(lowered_cells(), 2 * kInner);
}

TEST_F(StepEdgesOnGround, ADiagonalStepIsFound) {
  add_ground(0, 20, [](int column, int row) { return column > row ? 0.15 : 0.0; });
  EXPECT_NEAR(ground_up_to(10, 10), 0.05F, 1e-6F);
  EXPECT_NEAR(ground_up_to(11, 10), 0.05F, 1e-6F);
  EXPECT_NEAR(ground_up_to(13, 10), 0.65F, 1e-6F);
  EXPECT_NEAR(ground_up_to(8, 10), 0.5F, 1e-6F);
}

TEST_F(StepEdgesOnGround, NoSlopeIsAStep) {
  for (const double slope : {0.1, 0.3, 1.0}) {
    points_.emplace(map_);
    add_ground(0, 20, [slope](int column, int row) { return slope * (column + 0.5 * row); });
    EXPECT_EQ(lowered_cells(), 0) << slope;
  }
}

TEST_F(StepEdgesOnGround, AStepAcrossASlopeIsMeasuredFromTheSlope) {
  // 0.05 m a cell on both sides, 0.15 m more at the step.
  add_ground(0, 9, [](int column, int) { return 0.05 * column; });
  add_step(10, 0.5, 0.65);
  add_ground(11, 20, [](int column, int) { return 0.05 * column + 0.15; });
  config_.labels.max_step_m = 0.1417;
  EXPECT_EQ(lowered_cells(), kInner);
  config_.labels.max_step_m = 0.1420;
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, ARampOfTwoCellsIsNoStep) {
  add_ground(0, 9, level_ground);
  add_ground(10, 10, [](int, int) { return 0.075; });
  add_ground(11, 20, [](int, int) { return 0.15; });
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, AShortBumpIsNoStep) {
  add_ground(0, 20, level_ground);
  points_->add(10, 10, {0.3, 0.3, 0.3, 0.3, 0.3, 0.3});
  config_.labels.max_step_m = 0.05;
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, BothSidesMustBeSeen) {
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.15);
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, WhatIsNoGroundMakesNoStep) {
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.6);
  for (int row = 0; row < kSize; ++row)
    for (int column = 11; column < kSize; ++column) points_->add(column, row, {0.6, 0.6, 0.6});
  // The map stays at 0 there: 0.6 m is above the threshold.
  EXPECT_EQ(lowered_cells(), 0);
}

TEST_F(StepEdgesOnGround, TheScanBeforeIsForgotten) {
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.15);
  add_ground(11, 20, [](int, int) { return 0.15; });
  EXPECT_EQ(lowered_cells(), kInner);
  points_.emplace(map_);
  add_ground(0, 9, level_ground);
  add_step(10, 0.0, 0.15);
  EXPECT_EQ(lowered_cells(), 0);
}

}  // namespace
}  // namespace groundgrid
