#include "evaluation/deviation_calibration.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace groundgrid::evaluation {
namespace {

TEST(DeviationCalibration, CountsWhatLiesWithinOneAndTwo) {
  const std::array<JudgedHeight, 4> heights{{{0.1, 0.1}, {-0.15, 0.1}, {0.21, 0.1}, {0.0, 0.4}}};
  const DeviationCalibration figures = calibrate(heights);
  EXPECT_EQ(figures.cells, 4U);
  EXPECT_DOUBLE_EQ(figures.within_one, 0.5);
  EXPECT_DOUBLE_EQ(figures.within_two, 0.75);
  EXPECT_DOUBLE_EQ(figures.median_m, 0.1);
}

TEST(DeviationCalibration, WithoutCellsThereIsNothingToTell) {
  const DeviationCalibration figures = calibrate({});
  EXPECT_EQ(figures.cells, 0U);
  EXPECT_TRUE(std::isnan(figures.within_one));
  EXPECT_TRUE(std::isnan(figures.within_two));
  EXPECT_TRUE(std::isnan(figures.median_m));
}

}  // namespace
}  // namespace groundgrid::evaluation
