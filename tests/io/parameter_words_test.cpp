#include "program/parameter_words.hpp"

#include <gtest/gtest.h>

#include <cstdlib>
#include <limits>
#include <map>

namespace groundgrid::program {
namespace {

const Parameter& parameter(std::string_view name) {
  for (const Parameter& candidate : parameters())
    if (candidate.name == name) return candidate;
  throw std::invalid_argument("no parameter " + std::string(name));
}

TEST(ParameterWords, WriteNumbersShortAndWithoutLoss) {
  EXPECT_EQ(number_word(0.0), "0");
  EXPECT_EQ(number_word(0.33), "0.33");
  EXPECT_EQ(number_word(-10.0), "-10");
  EXPECT_EQ(number_word(5e-5), "5e-5");
  EXPECT_EQ(number_word(-1e6), "-1e6");
  EXPECT_EQ(number_word(1.25e-10), "1.25e-10");
  EXPECT_EQ(number_word(1e120), "1e120");
  const double third = 1.0 / 3.0;
  EXPECT_EQ(std::stod(number_word(third)), third);
  const double greatest = std::numeric_limits<double>::max();
  EXPECT_EQ(std::stod(number_word(greatest)), greatest);
}

TEST(ParameterWords, SayValuesOfEveryKind) {
  Config config;
  EXPECT_EQ(value_word(config, parameter("cell_size_m")), "0.33");
  EXPECT_EQ(value_word(config, parameter("own_variance_min_points")), "10");
  EXPECT_EQ(value_word(config, parameter("method")), "standard");
  EXPECT_EQ(value_word(Config::paper(), parameter("method")), "paper");
  EXPECT_EQ(value_word(config, parameter("sensor_height_m")), "none");
  config.sensor_height_m = 1.73;
  EXPECT_EQ(value_word(config, parameter("sensor_height_m")), "1.73");
}

TEST(ParameterWords, SayRanges) {
  EXPECT_EQ(range_word(parameter("cell_size_m")), "0.02 to 10");
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
