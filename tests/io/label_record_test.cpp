#include "evaluation/label_record.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace groundgrid::evaluation {
namespace {

using Labels = std::vector<std::uint32_t>;

TEST(LabelRecord, TellsEveryChangeOfAScan) {
  LabelRecord record;
  record.add(Labels{40, 99, 40});
  record.add(Labels{99, 99, 40});
  EXPECT_EQ(record.scans(), 2U);
  EXPECT_TRUE(record.holds(0, Labels{40, 99, 40}));
  EXPECT_TRUE(record.holds(1, Labels{99, 99, 40}));
  EXPECT_FALSE(record.holds(1, Labels{40, 99, 40}));
  EXPECT_FALSE(record.holds(0, Labels{40, 40, 99}));
  EXPECT_FALSE(record.holds(0, Labels{40, 99}));
  EXPECT_FALSE(record.holds(0, Labels{40, 99, 40, 0}));
  EXPECT_FALSE(record.holds(0, Labels{}));
}

TEST(LabelRecord, KnowsNoScanThatWasNotAdded) {
  LabelRecord record;
  record.add(Labels{});
  EXPECT_TRUE(record.holds(0, Labels{}));
  EXPECT_THROW((void)record.holds(1, Labels{}), std::out_of_range);
}

}  // namespace
}  // namespace groundgrid::evaluation
