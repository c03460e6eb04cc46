// Which cells are believed, and which returns are set aside because of them.
#include "core/stages/cell_support.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "support/stages.hpp"

namespace groundgrid {
namespace {

using testing::cell_index;
using testing::flat_map;
using testing::metre_grid;
using testing::PointsInCells;

/// A map of 41 × 41 cells of one metre; a surface needs 25 cells.
class CellSupportTest : public ::testing::Test {
 protected:
  CellSupportTest() : map_(flat_map(metre_grid(41))), support_(map_) {}

  void find(const PointsInCells& points) {
    bins_ = points.bins();
    paper::rasterize(bins_, grid_);
    support_.find(bins_, grid_);
  }
  std::size_t at(int column, int row) const { return cell_index(map_, column, row); }
  bool supported(int column, int row) const {
    return support_.is_supported()[at(column, row)] == 1;
  }

  ElevationMap map_;
  CellSupport support_;
  BinnedPoints bins_;
  ScanGrid grid_{map_.cells()};
};

TEST_F(CellSupportTest, NeedsAsManyCellsThatHangTogether) {
  PointsInCells points(map_);
  for (int column = 10; column < 35; ++column) points.add(column, 5, {0.0});
  for (int column = 10; column < 34; ++column) points.add(column, 20, {0.0});
  find(points);
  for (int column = 10; column < 35; ++column) EXPECT_TRUE(supported(column, 5)) << column;
  for (int column = 10; column < 34; ++column) EXPECT_FALSE(supported(column, 20)) << column;
}

TEST_F(CellSupportTest, CellsHangTogetherOverOneEmptyCellAndNotOverTwo) {
  PointsInCells points(map_);
  for (int column = 0; column < 40; ++column) {
    for (const int row : {4, 6}) points.add(column, row, {0.0});
    if (column % 3 == 0)
      for (const int row : {20, 23, 26}) points.add(column, row, {0.0});
  }
  find(points);
  EXPECT_TRUE(supported(10, 4));
  EXPECT_TRUE(supported(10, 6));
  EXPECT_FALSE(supported(15, 23));
}

TEST_F(CellSupportTest, ASurfaceMayBeAsSteepAsAnEmbankmentAndNotSteeper) {
  PointsInCells points(map_);
  for (int column = 10; column < 40; ++column) {
    points.add(column, 5, {0.7 * column});
    points.add(column, 20, {0.8 * column});
  }
  find(points);
  EXPECT_TRUE(supported(10, 5));
  EXPECT_FALSE(supported(10, 20));
}

TEST_F(CellSupportTest, RowsDoNotHangTogetherAroundTheEdgeOfTheMap) {
  PointsInCells points(map_);
  for (int i = 0; i < 15; ++i) {
    points.add(36 + i % 5, 5 + i / 5, {0.0});
    points.add(i % 5, 8 + i / 5, {0.0});
  }
  find(points);
  EXPECT_FALSE(supported(40, 7));
  EXPECT_FALSE(supported(0, 8));
}

TEST_F(CellSupportTest, SetsReturnsBelowTheSurfaceAsideAndKeepsThoseOnIt) {
  PointsInCells points(map_);
  for (int column = 10; column < 40; ++column) {
    if (column == 15)
      points.add(15, 5, {-4.0, 0.02, -9.0});
    else
      points.add(column, 5, {0.0});
  }
  find(points);
  EXPECT_TRUE(bins_.is_outlier(5));
  EXPECT_FALSE(bins_.is_outlier(6));
  EXPECT_TRUE(bins_.is_outlier(7));
  const CellStatistics& cell = grid_.statistics[at(15, 5)];
  EXPECT_EQ(cell.count, 1U);
  EXPECT_EQ(cell.min, 200);
  EXPECT_EQ(cell.max, 200);
  EXPECT_EQ(cell.sum, 200);
  EXPECT_TRUE(supported(15, 5)) << "what is left of it lies on the surface";
}

TEST_F(CellSupportTest, ACellOfWhichNothingIsLeftIsNotOccupied) {
  PointsInCells points(map_);
  for (int column = 10; column < 40; ++column) points.add(column, 5, {column == 15 ? -4.0 : 0.0});
  find(points);
  EXPECT_EQ(grid_.occupied.size(), 29U);
  EXPECT_EQ(grid_.is_occupied[at(15, 5)], 0);
  EXPECT_EQ(grid_.statistics[at(15, 5)].count, 0U);
}

TEST_F(CellSupportTest, FindsReturnsBelowASurfaceThatOthersHaveHidden) {
  // Two cells wide, so that the inner one has no supported neighbour before the outer one has.
  PointsInCells points(map_);
  for (int column = 5; column < 35; ++column) points.add(column, 5, {0.0});
  for (int column = 35; column < 39; ++column) points.add(column, 5, {0.0, -5.0 - column});
  find(points);
  for (int column = 35; column < 39; ++column)
    EXPECT_EQ(grid_.statistics[at(column, 5)].count, 1U) << column;
  EXPECT_TRUE(supported(38, 5));
}

TEST_F(CellSupportTest, ALowerLevelThatIsWideEnoughStays) {
  PointsInCells points(map_);
  for (int column = 10; column < 40; ++column) {
    points.add(column, 5, {0.0});
    points.add(column, 6, {-3.0});
  }
  find(points);
  EXPECT_TRUE(supported(15, 5));
  EXPECT_TRUE(supported(15, 6));
  EXPECT_EQ(grid_.occupied.size(), 60U);
}

TEST_F(CellSupportTest, ForgetsTheScanBefore) {
  PointsInCells first(map_);
  for (int column = 10; column < 40; ++column) first.add(column, 5, {0.0});
  find(first);
  PointsInCells second(map_);
  second.add(15, 5, {0.0});
  find(second);
  EXPECT_FALSE(supported(15, 5));
  EXPECT_FALSE(supported(14, 5));
}

}  // namespace
}  // namespace groundgrid
