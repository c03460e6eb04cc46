#include "groundgrid/config.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>

#include "groundgrid/parameters.hpp"
#include "groundgrid/version.hpp"

namespace groundgrid {
namespace {

/// Sets all numbers of a parameter to one value; those of a name are left alone.
void set_number(Config& config, const Parameter& parameter, double value) {
  struct Set {
    double value;
    void operator()(Method* /*method*/) const {}
    void operator()(int* number) const { *number = static_cast<int>(value); }
    void operator()(double* number) const { *number = value; }
    void operator()(std::optional<double>* number) const { *number = value; }
    void operator()(std::optional<Point2>* place) const { place->emplace().fill(value); }
    void operator()(std::optional<Box>* box) const { box->emplace().fill(value); }
  };
  std::visit(Set{value}, parameter.field(config));
}

TEST(Config, PaperHasTheValuesOfItsParameterSection) {
  const Config paper = Config::paper();                          // section IV-A
  EXPECT_EQ(paper.map.resolution_m, 0.33);                       // R
  EXPECT_EQ(paper.paper_only.variance_distance_factor, 1e-5);    // d_sf
  EXPECT_EQ(paper.paper_only.min_variance_threshold, 5 * 1e-5);  // t_minv
  EXPECT_EQ(paper.map.confidence_decay, 5.0);                    // θ
  EXPECT_EQ(paper.paper_only.min_point_fraction, 0.25);          // g_minp
  EXPECT_EQ(paper.paper_only.outlier_min_confidence, 1.25);      // o_minc
  EXPECT_EQ(paper.labels.ground_threshold_m, 0.3);               // h_g
  EXPECT_EQ(paper.paper_only.obstacle_threshold_m, 0.1);         // h_o
  EXPECT_EQ(paper.map.confidence_point_scale, 20.0);             // s
  EXPECT_EQ(paper.paper_only.outlier_tolerance_m, 0.1);          // o_t
  EXPECT_EQ(paper.paper_only.patch_change_distance_m, 20.0);     // d_ps
  EXPECT_EQ(paper.paper_only.azimuth_resolution_deg, 0.4);       // d_pv
  EXPECT_EQ(paper.paper_only.own_variance_min_points, 10);       // v_np
}

TEST(Config, PaperHasNoneOfTheDefaultsDeviations) {
  const Config paper = Config::paper();
  EXPECT_EQ(paper.method, Method::paper);
  EXPECT_EQ(Config{}.method, Method::standard);
  EXPECT_EQ(paper.vehicle.min_range_m, 0.0);  // no near zone
  EXPECT_FALSE(paper.vehicle.sensor_height_m.has_value());
}

TEST(Config, ThePapersMethodKnowsNoSteps) {
  Config config = Config::paper();
  config.labels.max_step_m = 0.1;
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
    if (is_name(parameter)) continue;
    Config any;
    const bool whole = std::holds_alternative<int*>(parameter.field(any));
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
  config.map.extent_m = 1000.0;
  config.map.resolution_m = 0.05;  // 20,000 cells wide
  EXPECT_NE(complaint_about(config).find("extent_m"), std::string::npos);
  config.map.extent_m = 30.0;
  config.map.resolution_m = 10.0;  // 3 cells wide
  EXPECT_NE(complaint_about(config).find("extent_m"), std::string::npos);
}

TEST(Config, ABoxMustHaveAnInside) {
  Config config;
  config.vehicle.ego_vehicle_box_m = {-1.0, 3.0, 1.0, -1.0, -2.0, 0.5};
  EXPECT_NE(complaint_about(config).find("ego_vehicle_box_m"), std::string::npos);
  config.vehicle.ego_vehicle_box_m = {-1.0, 3.0, -1.0, 1.0, -2.0, 0.5};
  EXPECT_NO_THROW(config.validate());
}

TEST(Version, IsTheSameAsAWordAndAsNumbers) {
  EXPECT_EQ(std::to_string(GROUNDGRID_VERSION_MAJOR) + "." +
                std::to_string(GROUNDGRID_VERSION_MINOR) + "." +
                std::to_string(GROUNDGRID_VERSION_PATCH),
            GROUNDGRID_VERSION);
}

}  // namespace
}  // namespace groundgrid
