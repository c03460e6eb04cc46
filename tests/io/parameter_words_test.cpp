#include "program/parameter_words.hpp"

#include <gtest/gtest.h>

#include <map>

namespace groundgrid::program {
namespace {

const Parameter& parameter(std::string_view name) {
  for (const Parameter& candidate : parameters())
    if (candidate.name == name) return candidate;
  throw std::invalid_argument("no parameter " + std::string(name));
}

TEST(ParameterWords, SayRanges) {
  EXPECT_EQ(range_word(parameter("resolution_m")), "0.02 to 10");
  EXPECT_EQ(range_word(parameter("sensor_height_m")), "-10 to 100");
  EXPECT_EQ(range_word(parameter("method")), "standard, paper, reference");
}

TEST(ParameterWords, HaveAHeadingForEveryStageAndEveryStageOnce) {
  std::map<std::string_view, int> begun;
  for (const Parameter& each : parameters()) {
    EXPECT_NE(stage_heading(each), each.group) << each.name;
    begun[each.group] += begins_stage(each) ? 1 : 0;
  }
  for (const auto& [stage, times] : begun) EXPECT_EQ(times, 1) << stage;
}

}  // namespace
}  // namespace groundgrid::program
