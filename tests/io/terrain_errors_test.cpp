#include "evaluation/terrain_errors.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace groundgrid::evaluation {
namespace {

TEST(TerrainErrors, AreThoseWorkedOutByHand) {
  // Five cells, four of them covered.
  const TerrainErrors errors = terrain_errors(5, {1.0, -2.0, 3.0, 0.0});
  EXPECT_EQ(errors.cells, 5U);
  EXPECT_EQ(errors.covered, 4U);
  EXPECT_DOUBLE_EQ(errors.coverage(), 0.8);
  EXPECT_DOUBLE_EQ(errors.rmse_m, std::sqrt(14.0 / 4.0));
  EXPECT_DOUBLE_EQ(errors.mae_m, 1.5);
  EXPECT_DOUBLE_EQ(errors.bias_m, 0.5);
  EXPECT_DOUBLE_EQ(errors.p95_m, 3.0);
}

TEST(TerrainErrors, TheNinetyFifthPercentIsExceededByNoMoreThanTheRest) {
  std::vector<double> errors;
  for (int i = 1; i <= 20; ++i) errors.push_back(i % 2 == 0 ? i : -i);
  EXPECT_DOUBLE_EQ(terrain_errors(20, errors).p95_m, 19.0);
  errors.push_back(21.0);
  EXPECT_DOUBLE_EQ(terrain_errors(21, errors).p95_m, 20.0);
  EXPECT_DOUBLE_EQ(terrain_errors(1, {-7.0}).p95_m, 7.0);
}

TEST(TerrainErrors, HaveNoFiguresOfNothing) {
  const TerrainErrors errors = terrain_errors(3, {});
  EXPECT_EQ(errors.coverage(), 0.0);
  EXPECT_TRUE(std::isnan(errors.rmse_m));
  EXPECT_TRUE(std::isnan(errors.mae_m));
  EXPECT_TRUE(std::isnan(errors.bias_m));
  EXPECT_TRUE(std::isnan(errors.p95_m));
  EXPECT_TRUE(std::isnan(terrain_errors(0, {}).coverage()));
}

TEST(Median, IsTheMiddleOrBetweenTheTwoInTheMiddle) {
  EXPECT_EQ(median({5.0, -1.0, 2.0}), 2.0);
  EXPECT_EQ(median({5.0, -1.0, 2.0, 3.0}), 2.5);
  EXPECT_TRUE(std::isnan(median({})));
}

}  // namespace
}  // namespace groundgrid::evaluation
