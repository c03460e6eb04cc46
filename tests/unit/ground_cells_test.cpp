// Classes of cells in place of paper III-C; eq. 3 shares the sums.
#include "core/stages/ground_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

/// Classifies the points of one scan on an 11 × 11 map of cells of one metre.
class GroundCellsTest : public ::testing::Test {
 protected:
  GroundCellsTest() : map_(flat_map(metre_grid(11))), points_(map_) {}

  const GroundCell& classified(int column, int row) {
    TileRunner runner(1);
    const ScanGrid& grid = points_.grid();
    cells_.classify(grid, map_, supported_, {&sensor_, 1}, runner);
    const auto cell = static_cast<std::uint32_t>(cell_index(map_, column, row));
    const auto at = std::find(grid.occupied.begin(), grid.occupied.end(), cell);
    return cells_.cells().at(static_cast<std::size_t>(at - grid.occupied.begin()));
  }

  ElevationMap map_;
  PointsInCells points_;
  std::vector<std::uint8_t> supported_ = std::vector<std::uint8_t>(121, 1);
  Point3f sensor_{5.5F, 5.5F, 1.7F};
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

TEST_F(GroundCellsTest, PatchIsFiveByFiveFar) {
  points_.add(8, 5, {0.14, 0.10});
  points_.add(9, 5, {0.20, 0.25, 0.30});
  points_.add(7, 6, {0.05});
  points_.add(10, 5, {1.0, 1.0, 1.1, 1.2});  // two cells away
  sensor_.x = 8.5F + 39.9F;
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 6.0F);
  sensor_.x = 8.5F + 40.1F;
  // (0.85 + 4 · 1.0) / 10 = 0.485
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 10.0F);
  EXPECT_NEAR(classified(8, 5).patch_elevation, 0.485F, 1e-6F);
}

TEST_F(GroundCellsTest, DistanceIsPlanarAndToTheNearestSensor) {
  points_.add(8, 5, {0.0});
  points_.add(10, 5, {0.0});  // two cells away
  sensor_ = {8.5F, -40.0F, 1.7F};
  EXPECT_FLOAT_EQ(classified(8, 5).patch_points, 2.0F) << "45 m from the only sensor";
  TileRunner runner(1);
  const Point3f two[] = {sensor_, {8.5F, -20.0F, -90.0F}};
  cells_.classify(points_.grid(), map_, supported_, two, runner);
  EXPECT_FLOAT_EQ(cells_.cells().at(0).patch_points, 1.0F) << "25 m from the other one";
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

TEST_F(GroundCellsTest, EnoughPointsTakeTheirOwnVariance) {
  points_.add(5, 5, {0.0, 0.02, 0.0, 0.02, 0.0, 0.02, 0.0, 0.02, 0.0});
  points_.add(6, 5, {0.0, 0.04});
  EXPECT_GT(classified(5, 5).variance, 1.4e-4F);  // 9 points: below v_np = 10, the patch's
  points_.add(5, 5, {0.02});
  EXPECT_NEAR(classified(5, 5).variance, 1e-4F, 1e-9F);
}

TEST_F(GroundCellsTest, GroundIsWhatVariesLessThanTheThreshold) {
  points_.add(10, 5, {0.0, 0.062});  // variance 0.031² = 0.00096 m²
  EXPECT_TRUE(classified(10, 5).ground);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 10, 5)], 1);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 9, 5)], 0);
  points_.add(10, 5, {0.0, 0.07});  // mean 0.033, variance 0.0011 m²
  EXPECT_FALSE(classified(10, 5).ground);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 10, 5)], 0);
}

TEST_F(GroundCellsTest, WithoutSupportASmoothCellIsLoneAndARoughOneNothing) {
  supported_.assign(121, 0);
  points_.add(2, 2, {0.0, 0.01});
  points_.add(8, 8, {0.0, 0.5});
  EXPECT_TRUE(classified(2, 2).lone);
  EXPECT_FALSE(classified(2, 2).ground);
  EXPECT_FALSE(classified(2, 2).observed);
  EXPECT_FALSE(classified(8, 8).lone);
}

/// Three cells in a row that rise by this much each, four points at the quarters of each of them,
/// which have a variance of 0.078125 · rise².
void add_slope(double rise, PointsInCells& points) {
  for (int column = 4; column <= 6; ++column)
    for (const double part : {0.125, 0.375, 0.625, 0.875})
      points.add(column, 5, {rise * (column + part)});
}

TEST_F(GroundCellsTest, ASlopeIsNoRoughness) {
  // 0.3² · 0.078125 = 0.0070 m², and 0.001 + 0.3² / 12 = 0.0085 are allowed.
  add_slope(0.3, points_);
  EXPECT_TRUE(classified(5, 5).ground);
  EXPECT_FALSE(classified(4, 5).ground) << "nothing is known on its other side";
}

TEST_F(GroundCellsTest, WhatIsSteeperThanAnEmbankmentIsRough) {
  add_slope(0.8, points_);  // 0.0500 m², and 0.001 + 0.7² / 12 = 0.0418 are allowed
  EXPECT_FALSE(classified(5, 5).ground);
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
  cells_.classify(next.grid(), map_, supported_, {&sensor_, 1}, runner);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 6, 5)], 0);
  EXPECT_EQ(cells_.is_ground()[cell_index(map_, 8, 5)], 1);
  EXPECT_FLOAT_EQ(cells_.cells().at(0).patch_points, 2.0F);
}

}  // namespace
}  // namespace groundgrid
