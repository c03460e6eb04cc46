#include "rendering/height_grid.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace groundgrid::rendering {
namespace {

const float kNone = std::nanf("");

HeightGrid grid_of(int columns, int rows, std::vector<float> heights) {
  return {.columns = columns,
          .rows = rows,
          .west_m = 100.0,
          .north_m = 50.0,
          .cell_width_m = 2.0,
          .cell_height_m = 1.0,
          .heights_m = std::move(heights)};
}

TEST(HeightGrid, IsCroppedToItsHeights) {
  const HeightGrid part = cropped(grid_of(4, 3,
                                          {kNone, kNone, kNone, kNone,  //
                                           kNone, kNone, 1.0F, kNone,   //
                                           kNone, 2.0F, kNone, kNone}));
  EXPECT_EQ(part.columns, 2);
  EXPECT_EQ(part.rows, 2);
  EXPECT_DOUBLE_EQ(part.west_m, 102.0);
  EXPECT_DOUBLE_EQ(part.north_m, 49.0);
  EXPECT_TRUE(std::isnan(part.at(0, 0)));
  EXPECT_EQ(part.at(1, 0), 1.0F);
  EXPECT_EQ(part.at(0, 1), 2.0F);
}

TEST(HeightGrid, WithoutHeightsNothingIsLeft) {
  EXPECT_EQ(cropped(grid_of(2, 1, {kNone, kNone})).columns, 0);
}

TEST(HeightGrid, CoarseCellsAreTheMeansOfTheirHeights) {
  const HeightGrid coarse = coarsened(grid_of(3, 2,
                                              {1.0F, 2.0F, 7.0F,  //
                                               kNone, 6.0F, kNone}),
                                      2);
  EXPECT_EQ(coarse.columns, 2);
  EXPECT_EQ(coarse.rows, 1);
  EXPECT_DOUBLE_EQ(coarse.cell_width_m, 4.0);
  EXPECT_DOUBLE_EQ(coarse.cell_height_m, 2.0);
  EXPECT_EQ(coarse.at(0, 0), 3.0F);
  EXPECT_EQ(coarse.at(1, 0), 7.0F);
}

TEST(HeightGrid, StaysAsItIsWhereItIsCoarseEnough) {
  EXPECT_EQ(coarsened(grid_of(2, 1, {1.0F, 2.0F}), 2).heights_m, (std::vector<float>{1.0F, 2.0F}));
}

TEST(HeightGrid, TheRangeLeavesAShareOutAtBothEnds) {
  std::vector<float> values{kNone, 1e9F};
  for (int i = 1; i <= 100; ++i) values.push_back(static_cast<float>(i));
  const ValueRange range = range_of(values, 0.01);
  EXPECT_DOUBLE_EQ(range.low, 2.0);
  EXPECT_DOUBLE_EQ(range.high, 100.0);
  EXPECT_DOUBLE_EQ(range_of({kNone}, 0.01).high, 0.0);
}

}  // namespace
}  // namespace groundgrid::rendering
