#include "program/point_groups.hpp"

#include <gtest/gtest.h>

#include <array>
#include <stdexcept>
#include <string>
#include <vector>

namespace groundgrid::program {
namespace {

std::vector<std::string> names_of(const PointGroups& groups) {
  std::vector<std::string> names;
  for (const std::uint8_t group : groups.group) names.push_back(groups.styles.at(group).name);
  return names;
}

TEST(PointGroups, OfLabelsAreThoseOfAnyMethod) {
  // Ours, another method's 50 and 49, an instance number above the class.
  const std::array<std::uint32_t, 7> labels{40, 99, 1, 0, 50, 49, 0x00050001};
  EXPECT_EQ(names_of(groups_by_label(labels)),
            (std::vector<std::string>{"ground", "obstacle", "outlier", "unknown", "obstacle",
                                      "ground", "outlier"}));
}

TEST(PointGroups, OfErrorsAreCountedAsByEvaluate) {
  // Road found and missed and unanswered, a car right and wrong and unanswered, vegetation.
  const std::array<std::uint32_t, 7> truth{40, 40, 40, 10, 10, 10, 70};
  const std::array<std::uint32_t, 7> labels{40, 99, 0, 99, 40, 0, 40};
  EXPECT_EQ(names_of(groups_by_error(truth, labels)),
            (std::vector<std::string>{"true positive", "false negative", "false negative",
                                      "true negative", "false positive", "true negative",
                                      "not counted"}));
}

TEST(PointGroups, NeedATruthForEachLabel) {
  const std::array<std::uint32_t, 2> two{40, 40};
  EXPECT_THROW((void)groups_by_error({}, two), std::invalid_argument);
}

}  // namespace
}  // namespace groundgrid::program
