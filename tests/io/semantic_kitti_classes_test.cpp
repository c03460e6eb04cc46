#include "evaluation/semantic_kitti_classes.hpp"

#include <gtest/gtest.h>

#include <set>

namespace groundgrid::evaluation {
namespace {

TEST(SemanticKittiClasses, CountAsThePaperSays) {
  const std::set<int> ground{40, 44, 48, 49, 60, 72};
  const std::set<int> ignored{0, 1, 70};
  for (int number = 0; number <= 0xFFFF; ++number) {
    const Truth expected = ground.contains(number)    ? Truth::ground
                           : ignored.contains(number) ? Truth::ignored
                                                      : Truth::non_ground;
    ASSERT_EQ(truth_of(static_cast<std::uint16_t>(number)), expected) << number;
  }
}

TEST(SemanticKittiClasses, HaveNamesOrNumbers) {
  EXPECT_EQ(class_name(0), "unlabeled");
  EXPECT_EQ(class_name(72), "terrain");
  EXPECT_EQ(class_name(259), "moving-other-vehicle");
  EXPECT_EQ(class_name(260), "260");
  EXPECT_EQ(class_name(41), "41");
}

}  // namespace
}  // namespace groundgrid::evaluation
