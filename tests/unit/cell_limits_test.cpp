// The rule that the default has in place of paper III-F's two classes.
#include "core/stages/cell_limits.hpp"

#include <gtest/gtest.h>

#include <utility>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

class CellLimitsByColumn : public ::testing::Test {
 protected:
  CellLimitsByColumn() : config_(metre_grid(21)), map_(flat_map(config_)), points_(map_) {
    config_.labels.ground_threshold_m = 0.2;
  }

  CellLimit limit(int column, int row) {
    limits_.choose_by_column(points_.bins(), points_.grid(), map_, config_, runner_);
    return std::as_const(limits_).limits()[cell_index(map_, column, row)];
  }

  Config config_;
  ElevationMap map_;
  PointsInCells points_;
  TileRunner runner_{2};
  CellLimits limits_{map_, runner_};
};

TEST_F(CellLimitsByColumn, WhatRisesFromTheGroundTightensTheThreshold) {
  points_.add(3, 3, {0.0, 0.02});
  points_.add(10, 10, {0.0, 0.02, 0.5});  // something stands here
  points_.add(17, 17, {0.0, 0.02, 2.5});  // a crown or a bridge
  EXPECT_FLOAT_EQ(limit(3, 3).threshold, 0.2F);
  EXPECT_FLOAT_EQ(limit(10, 10).threshold, 0.06F);
  EXPECT_FLOAT_EQ(limit(17, 17).threshold, 0.2F);
}

TEST_F(CellLimitsByColumn, TheLevelIsTheMeanOfTheGroundPointsAroundNotTheirMinimum) {
  // The map's height rests on minima, 0 here; the points lie 0.04 m higher on the average.
  for (int y = 8; y <= 12; ++y)
    for (int x = 8; x <= 12; ++x)
      points_.add(x, y, {0.0, 0.02, 0.04, 0.06, 0.08, 0.0, 0.02, 0.04, 0.06, 0.08});
  EXPECT_NEAR(limit(10, 10).level, 0.04F, 0.003F);
}

TEST_F(CellLimitsByColumn, FeetOfWhatStandsDoNotRaiseTheLevel) {
  points_.add(10, 10, {0.1, 0.12, 0.14, 0.1, 0.12, 0.14, 0.6});
  EXPECT_NEAR(limit(10, 10).level, 0.0F, 1e-6F);
}

TEST_F(CellLimitsByColumn, TheScanBeforeIsForgotten) {
  points_.add(10, 10, {0.1, 0.1, 0.1, 0.1, 0.1, 0.1});
  EXPECT_GT(limit(10, 10).level, 0.05F);
  PointsInCells next(map_);
  next.add(11, 10, {0.0});
  TileRunner runner(1);
  limits_.choose_by_column(next.bins(), next.grid(), map_, config_, runner);
  EXPECT_NEAR(std::as_const(limits_).limits()[cell_index(map_, 11, 10)].level, 0.0F, 1e-6F);
}

}  // namespace
}  // namespace groundgrid
