#include "groundgrid/config.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

#include "groundgrid/parameters.hpp"

namespace groundgrid {
namespace {

void set_number(Config& config, const Parameter& parameter, double value) {
  if (const auto* number = std::get_if<double Config::*>(&parameter.member))
    config.*(*number) = value;
  else if (const auto* optional = std::get_if<std::optional<double> Config::*>(&parameter.member))
    config.*(*optional) = value;
  else if (const auto* whole = std::get_if<int Config::*>(&parameter.member))
    config.*(*whole) = static_cast<int>(value);
}

TEST(Config, PaperHasTheValuesOfItsParameterSection) {
  const Config paper = Config::paper();               // section IV-A
  EXPECT_EQ(paper.cell_size_m, 0.33);                 // R
  EXPECT_EQ(paper.variance_distance_factor, 1e-5);    // d_sf
  EXPECT_EQ(paper.min_variance_threshold, 5 * 1e-5);  // t_minv
  EXPECT_EQ(paper.confidence_decay, 5.0);             // θ
  EXPECT_EQ(paper.min_point_fraction, 0.25);          // g_minp
  EXPECT_EQ(paper.outlier_min_confidence, 1.25);      // o_minc
  EXPECT_EQ(paper.ground_threshold_m, 0.3);           // h_g
  EXPECT_EQ(paper.obstacle_threshold_m, 0.1);         // h_o
  EXPECT_EQ(paper.confidence_point_scale, 20.0);      // s
  EXPECT_EQ(paper.outlier_tolerance_m, 0.1);          // o_t
  EXPECT_EQ(paper.patch_change_distance_m, 20.0);     // d_ps
  EXPECT_EQ(paper.point_angle_deg, 0.4);              // d_pv
  EXPECT_EQ(paper.own_variance_min_points, 10);       // v_np
}

TEST(Config, PaperHasNoneOfTheDefaultsDeviations) {
  const Config paper = Config::paper();
  EXPECT_EQ(paper.method, Method::paper);
  EXPECT_EQ(Config{}.method, Method::standard);
  EXPECT_EQ(paper.min_range_m, 0.0);  // no near zone
  EXPECT_FALSE(paper.sensor_height_m.has_value());
}

TEST(Config, ThePapersMethodKnowsNoSteps) {
  Config config = Config::paper();
  config.max_step_m = 0.1;
  EXPECT_THROW(config.validate(), std::invalid_argument);
  config.method = Method::standard;
  EXPECT_NO_THROW(config.validate());
}

TEST(Config, WhatOnlyThePaperHasIsRefusedInOurMethod) {
  for (const Parameter& parameter : parameters()) {
    if (parameter.group != "paper") continue;
    Config config;
    set_number(config, parameter, parameter.max);
    EXPECT_THROW(config.validate(), std::invalid_argument) << parameter.name;
    config.method = Method::paper;
    EXPECT_NO_THROW(config.validate()) << parameter.name;
  }
}

TEST(Config, BothPresetsAreValid) {
  EXPECT_NO_THROW(Config{}.validate());
  EXPECT_NO_THROW(Config::paper().validate());
}

std::string complaint_about(const Config& config) {
  try {
    config.validate();
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(Config, ValidateNamesTheFieldThatIsOutOfRangeOrNotANumber) {
  for (const Parameter& parameter : parameters()) {
    if (std::holds_alternative<Method Config::*>(parameter.member)) continue;
    const bool whole = std::holds_alternative<int Config::*>(parameter.member);
    const double inf = std::numeric_limits<double>::infinity();
    const double below = whole ? parameter.min - 1 : std::nextafter(parameter.min, -inf);
    const double above = whole ? parameter.max + 1 : std::nextafter(parameter.max, inf);
    const std::string name(parameter.name);
    for (const double value : {below, above, inf, -inf, std::nan("")}) {
      if (whole && !std::isfinite(value)) continue;
      Config config;
      set_number(config, parameter, value);
      EXPECT_NE(complaint_about(config).find(name), std::string::npos)
          << name << " = " << value << ": " << complaint_about(config);
    }
  }
}

TEST(Config, MapsOfTooManyOrTooFewCellsAreRejected) {
  Config config;
  config.map_extent_m = 1000.0;
  config.cell_size_m = 0.05;  // 20,000 cells wide
  EXPECT_NE(complaint_about(config).find("map_extent_m"), std::string::npos);
  config.map_extent_m = 30.0;
  config.cell_size_m = 10.0;  // 3 cells wide
  EXPECT_NE(complaint_about(config).find("map_extent_m"), std::string::npos);
}

}  // namespace
}  // namespace groundgrid
