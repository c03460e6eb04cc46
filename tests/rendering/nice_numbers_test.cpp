#include "rendering/nice_numbers.hpp"

#include <gtest/gtest.h>

namespace groundgrid::rendering {
namespace {

TEST(NiceNumbers, AreOneTwoAndFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(nice_below(1.0), 1.0);
  EXPECT_DOUBLE_EQ(nice_below(1.99), 1.0);
  EXPECT_DOUBLE_EQ(nice_below(2.0), 2.0);
  EXPECT_DOUBLE_EQ(nice_below(4.99), 2.0);
  EXPECT_DOUBLE_EQ(nice_below(5.0), 5.0);
  EXPECT_DOUBLE_EQ(nice_below(999.0), 500.0);
  EXPECT_DOUBLE_EQ(nice_below(1000.0), 1000.0);
  EXPECT_DOUBLE_EQ(nice_below(0.03), 0.02);
  EXPECT_DOUBLE_EQ(nice_below(0.1), 0.1);
}

TEST(NiceNumbers, AboveALimitAreTheNextOnes) {
  EXPECT_DOUBLE_EQ(nice_above(1.0), 1.0);
  EXPECT_DOUBLE_EQ(nice_above(1.1), 2.0);
  EXPECT_DOUBLE_EQ(nice_above(2.1), 5.0);
  EXPECT_DOUBLE_EQ(nice_above(0.51), 1.0);
  EXPECT_DOUBLE_EQ(nice_above(0.05), 0.05);
}

TEST(NiceNumbers, TicksAreMultiplesWithinTheRangeAndNotTooMany) {
  EXPECT_EQ(ticks_between(-1.0, 1.0, 5), (std::vector<double>{-1.0, -0.5, 0.0, 0.5, 1.0}));
  EXPECT_EQ(ticks_between(-1.0, 1.0, 4), (std::vector<double>{-1.0, 0.0, 1.0}));
  EXPECT_EQ(ticks_between(3.0, 47.0, 9), (std::vector<double>{10.0, 20.0, 30.0, 40.0}));
}

TEST(NiceNumbers, TicksHaveAsManyDecimalsAsTheirStep) {
  EXPECT_EQ(tick_text(0.5, 0.5), "0.5");
  EXPECT_EQ(tick_text(-1.0, 0.5), "\u22121.0");
  EXPECT_EQ(tick_text(0.02, 0.02), "0.02");
  EXPECT_EQ(tick_text(120.0, 20.0), "120");
}

}  // namespace
}  // namespace groundgrid::rendering
