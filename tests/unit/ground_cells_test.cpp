// Paper III-C: eq. 1 and 2, patches, v_np and the fraction of expected points; eq. 3 shares its
// sums.
#include "core/ground_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

/// Classifies the points of one scan on an 11 × 11 map with the sensor over cell (5, 5).
class GroundCellsTest : public ::testing::Test {
 protected:
  GroundCellsTest() : config_(metre_grid(11)), map_(flat_map(config_)), points_(map_) {
    config_.min_point_fraction = 0.0;
  }

  const GroundCell& classified(int column, int row) {
    TileRunner runner(1);
    const ScanGrid& grid = points_.grid();
    cells_.classify(grid, map_, SensorPositions{{{5.5F, 5.5F, 1.7F}}}, config_, runner);
    const auto cell = static_cast<std::uint32_t>(cell_index(map_, column, row));
    const auto at = std::find(grid.occupied.begin(), grid.occupied.end(), cell);
    return cells_.cells().at(static_cast<std::size_t>(at - grid.occupied.begin()));
  }

  Config config_;
  ElevationMap map_;
  PointsInCells points_;
  GroundCells cells_{121};
};

TEST_F(GroundCellsTest, PatchElevationIsTheCountWeightedMeanOfMinima) {
  points_.add(5, 5, {0.14, 0.10});          // 2 points, minimum 0.10
  points_.add(6, 5, {0.20, 0.25, 0.30});    // 3 points, minimum 0.20
  points_.add(4, 6, {0.05});                // 1 point
  points_.add(7, 5, {1.0, 1.0, 1.1, 1.2});  // outside of the 3×3 cells
  // Eq. 3: (2·0.10 + 3·0.20 + 1·0.05) / (2 + 3 + 1) = 0.85 / 6 = 0.141667
  const GroundCell& cell = classified(5, 5);
  EXPECT_FLOAT_EQ(cell.patch_points, 6.0F);
  EXPECT_NEAR(cell.patch_elevation, 0.141667F, 1e-6F);
}

TEST_F(GroundCellsTest, PatchIsFiveByFiveFromTheChangeDistanceOn) {
  points_.add(8, 5, {0.14, 0.10});  // 3 m from the sensor
  points_.add(9, 5, {0.20, 0.25, 0.30});
  points_.add(7, 6, {0.05});
  points_.add(10, 5, {1.0, 1.0, 1.1, 1.2});  // two cells away
  config_.patch_change_distance_m = 3.1;
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 6.0F);
  config_.patch_change_distance_m = 3.0;
  // (0.85 + 4·1.0) / 10 = 0.485
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 10.0F);
  EXPECT_NEAR(classified(8, 5).patch_elevation, 0.485F, 1e-6F);
}

TEST_F(GroundCellsTest, PatchEndsAtTheMapsEdge) {
  points_.add(0, 0, {0.1});
  points_.add(10, 0, {0.7});  // would be a neighbour if rows ran into each other
  points_.add(1, 1, {0.3});
  EXPECT_FLOAT_EQ(classified(0, 0).patch_points, 2.0F);
  EXPECT_NEAR(classified(0, 0).patch_elevation, 0.2F, 1e-6F);
}

TEST_F(GroundCellsTest, FewPointsTakeTheVarianceOfThePatch) {
  points_.add(5, 5, {0.0, 0.02});  // mean 0.01, variance (0.01² + 0.01²) / 2 = 1e-4
  points_.add(6, 5, {0.0, 0.04});  // variance 4e-4
  // (2·1e-4 + 2·4e-4) / 4 = 2.5e-4
  EXPECT_NEAR(classified(5, 5).variance, 2.5e-4F, 1e-9F);
}

TEST(SlopeAlong, IsTheFlatterSideAndNoneWhereTheGroundTurns) {
  EXPECT_FLOAT_EQ(slope_along(1.0F, 1.1F, 1.3F, 0.5F), 0.2F);
  EXPECT_FLOAT_EQ(slope_along(1.3F, 1.1F, 1.0F, 0.5F), -0.2F);
  EXPECT_FLOAT_EQ(slope_along(1.0F, 1.1F, 9.0F, 0.5F), 0.2F);
  EXPECT_EQ(slope_along(1.0F, 1.1F, 1.0F, 0.5F), 0.0F);
  EXPECT_EQ(slope_along(1.0F, 1.0F, 9.0F, 0.5F), 0.0F);
}

TEST_F(GroundCellsTest, ASlopeIsNoRoughness) {
  // Cells of 1 m that rise by 0.3 m each: the rise within a cell has a variance of 0.3² / 12 =
  // 0.0075 m². Four points at the quarters of a cell have one of 0.3² · 0.078125 = 0.00703 m².
  config_.min_variance_threshold = 1e-4;
  config_.variance_distance_factor = 0.0;
  config_.own_variance_min_points = 1;
  for (int column = 4; column <= 6; ++column)
    for (const double part : {0.125, 0.375, 0.625, 0.875})
      points_.add(column, 5, {0.3 * (column + part)});
  config_.max_cell_slope = 0.0;
  EXPECT_FALSE(classified(5, 5).ground);
  config_.max_cell_slope = 0.29;  // 0.29² / 12 = 0.00701, and the threshold: 0.00711
  EXPECT_TRUE(classified(5, 5).ground);
  config_.max_cell_slope = 0.28;  // 0.00653 + 0.0001
  EXPECT_FALSE(classified(5, 5).ground);
  config_.max_cell_slope = 0.7;
  EXPECT_TRUE(classified(5, 5).ground);
  EXPECT_FALSE(classified(4, 5).ground);  // nothing is known on its other side
}

TEST_F(GroundCellsTest, EnoughPointsTakeTheirOwnVariance) {
  points_.add(5, 5, {0.0, 0.02, 0.0, 0.02, 0.0, 0.02, 0.0, 0.02, 0.0});
  points_.add(6, 5, {0.0, 0.04});
  EXPECT_GT(classified(5, 5).variance, 1.4e-4F);  // 9 points: below v_np = 10, the patch's
  points_.add(5, 5, {0.02});
  EXPECT_NEAR(classified(5, 5).variance, 1e-4F, 1e-9F);
}

TEST_F(GroundCellsTest, GroundIsWhatVariesLessThanTheThreshold) {
  // 5 m from the sensor the threshold is 1e-5 · 5 = 5e-5.
  points_.add(10, 5, {0.0, 0.013});  // variance 0.0065² = 4.2e-5
  EXPECT_TRUE(classified(10, 5).ground);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 10, 5)], 1);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 9, 5)], 0);
  points_.add(10, 5, {0.0, 0.016});  // mean 0.00725, variance 5.4e-5
  EXPECT_FALSE(classified(10, 5).ground);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 10, 5)], 0);
}

TEST_F(GroundCellsTest, CellsWithTooFewOfTheExpectedPointsAreSkipped) {
  // One metre from the sensor: atan(1) = 45°; with 4.5° a point n = 10, a quarter is 2.5.
  config_.point_angle_deg = 4.5;
  config_.min_point_fraction = 0.25;
  points_.add(6, 5, {0.0, 0.0});
  points_.add(6, 6, {0.0, 0.0, 0.0, 0.0});  // the neighbours' points do not help
  EXPECT_FALSE(classified(6, 5).observed);
  EXPECT_FALSE(classified(6, 5).ground);
  points_.add(6, 5, {0.0});
  EXPECT_TRUE(classified(6, 5).observed);
  EXPECT_TRUE(classified(6, 5).ground);
}

TEST_F(GroundCellsTest, AWithdrawnCellIsNoGround) {
  points_.add(6, 5, {0.0, 0.0});
  EXPECT_TRUE(classified(6, 5).ground);
  cells_.withdraw(0, static_cast<std::uint32_t>(cell_index(map_, 6, 5)));
  EXPECT_FALSE(cells_.cells().at(0).ground);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 6, 5)], 0);
}

TEST_F(GroundCellsTest, AnswersOfTheScanBeforeAreForgotten) {
  points_.add(6, 5, {0.0, 0.0});
  EXPECT_TRUE(classified(6, 5).ground);
  PointsInCells next(map_);
  next.add(8, 5, {0.0, 0.0});
  TileRunner runner(1);
  cells_.classify(next.grid(), map_, SensorPositions{{{5.5F, 5.5F, 1.7F}}}, config_, runner);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 6, 5)], 0);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 8, 5)], 1);
  EXPECT_FLOAT_EQ(cells_.cells().at(0).patch_points, 2.0F);
}

TEST_F(GroundCellsTest, DistanceIsPlanarAndToTheNearestSensor) {
  config_.patch_change_distance_m = 2.0;
  points_.add(8, 5, {0.0});
  points_.add(10, 5, {0.0});  // two cells away
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 2.0F) << "3 m from the only sensor";
  TileRunner runner(1);
  const SensorPositions two{{{5.5F, 5.5F, 1.7F}, {8.5F, 6.5F, -40.0F}}};
  cells_.classify(points_.grid(), map_, two, config_, runner);
  EXPECT_FLOAT_EQ(cells_.cells().at(0).patch_points, 1.0F) << "1 m from the other one";
}

}  // namespace
}  // namespace groundgrid
