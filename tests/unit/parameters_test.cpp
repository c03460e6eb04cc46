#include "groundgrid/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

namespace groundgrid {
namespace {

/// Where a field lies in Config.
std::ptrdiff_t offset_of(const Parameter& parameter) {
  static Config config;
  const auto* begin = reinterpret_cast<const std::byte*>(&config);
  return std::visit([&](auto* field) { return reinterpret_cast<const std::byte*>(field) - begin; },
                    parameter.field(config));
}

/// The doc comments in config.hpp by the name of the field that follows them.
std::map<std::string, std::string> comments_in_header() {
  std::ifstream header(GROUNDGRID_CONFIG_HEADER);
  std::map<std::string, std::string> comments;
  std::string comment;
  for (std::string line; std::getline(header, line);) {
    if (const std::size_t at = line.find("/// "); at != std::string::npos) {
      if (!comment.empty()) comment += ' ';
      comment += line.substr(at + 4);
      continue;
    }
    // "    double resolution_m = 0.33;" or "    std::optional<double> sensor_height_m{};"
    if (line.starts_with("using ") ||
        (line.find(" = ") == std::string::npos && line.find("{};") == std::string::npos)) {
      comment.clear();
      continue;
    }
    const std::string declaration = line.substr(0, std::min(line.find(" = "), line.find("{}")));
    comments[declaration.substr(declaration.rfind(' ') + 1)] = comment;
    comment.clear();
  }
  return comments;
}

TEST(Parameters, TableHasEveryFieldOfConfigOnceAndInOrder) {
  EXPECT_EQ(parameters().size(), comments_in_header().size());
  std::set<std::string_view> names;
  std::ptrdiff_t last = -1;
  for (const Parameter& parameter : parameters()) {
    EXPECT_TRUE(names.insert(parameter.name).second) << parameter.name << " is there twice";
    EXPECT_GT(offset_of(parameter), last) << parameter.name << " is out of the struct's order";
    last = offset_of(parameter);
  }
}

TEST(Parameters, AreDescribedAndTheirDefaultsAreInRange) {
  const Config paper = Config::paper();
  for (const Parameter& parameter : parameters()) {
    EXPECT_FALSE(parameter.text.empty()) << parameter.name;
    EXPECT_TRUE(parameter.text.ends_with('.')) << parameter.name;
    EXPECT_FALSE(parameter.group.empty()) << parameter.name;
    EXPECT_LT(parameter.min, parameter.max) << parameter.name;
    for (const Config& config : {Config{}, paper}) {
      for (const double number : numbers_of(config, parameter)) {
        EXPECT_GE(number, parameter.min) << parameter.name;
        EXPECT_LE(number, parameter.max) << parameter.name;
      }
    }
    EXPECT_EQ(parameter.name.ends_with("_m"),
              parameter.unit == "m" && parameter.name != "variance_distance_factor")
        << parameter.name << " and its unit disagree";
    EXPECT_EQ(parameter.name.ends_with("_deg"), parameter.unit == "deg") << parameter.name;
  }
}

/// The doc comment of a field as the table would have it.
std::string expected_comment(const Parameter& parameter) {
  std::ostringstream comment;
  comment << parameter.text;
  const bool has_symbol = !parameter.symbol.empty();
  const bool has_unit = !parameter.unit.empty();
  if (has_symbol || has_unit) comment << " (";
  if (has_symbol) comment << "paper: " << parameter.symbol;
  if (has_symbol && has_unit) comment << ", ";
  if (has_unit) comment << parameter.unit;
  if (has_symbol || has_unit) comment << ")";
  return comment.str();
}

TEST(Parameters, AgreeWithTheCommentsInTheHeader) {
  const std::map<std::string, std::string> comments = comments_in_header();
  for (const Parameter& parameter : parameters()) {
    const auto found = comments.find(std::string(parameter.name));
    ASSERT_NE(found, comments.end()) << parameter.name;
    EXPECT_EQ(found->second, expected_comment(parameter)) << parameter.name;
  }
}

TEST(SetParameter, SetsFieldsOfEachKind) {
  Config config;
  set_parameter(config, "resolution_m", "0.25");
  set_parameter(config, "sensor_height_m", "1.73");
  set_parameter(config, "method", "paper");
  set_parameter(config, "own_variance_min_points", "7");
  EXPECT_EQ(config.map.resolution_m, 0.25);
  EXPECT_EQ(config.vehicle.sensor_height_m, 1.73);
  EXPECT_EQ(config.paper_only.own_variance_min_points, 7);
  EXPECT_EQ(config.method, Method::paper);
  set_parameter(config, "sensor_height_m", "none");
  set_parameter(config, "own_variance_min_points", "10");
  set_parameter(config, "method", "standard");
  EXPECT_FALSE(config.vehicle.sensor_height_m.has_value());
  EXPECT_EQ(config.method, Method::standard);
}

TEST(SetParameter, SetsListsWithAndWithoutBrackets) {
  Config config;
  set_parameter(config, "anchor_m", "1.5,-2");
  EXPECT_EQ(config.map.anchor_m, (Point2{1.5, -2.0}));
  set_parameter(config, "ego_vehicle_box_m", "[-1, 3, -1, 1, -2, 0.5]");
  EXPECT_EQ(config.vehicle.ego_vehicle_box_m, (Box{-1.0, 3.0, -1.0, 1.0, -2.0, 0.5}));
  set_parameter(config, "anchor_m", "none");
  EXPECT_FALSE(config.map.anchor_m.has_value());
}

TEST(SetParameter, ReachesEveryFieldAndTextOfGivesItBack) {
  for (const Parameter& parameter : parameters()) {
    if (is_name(parameter)) continue;
    Config config;
    if (parameter.group == "paper") config.method = Method::paper;
    std::string text = "none";
    if (parameter.name == "ego_vehicle_box_m") {
      text = "[-1, 3, -1.5, 1, -2, 0.5]";
    } else if (parameter.name == "anchor_m") {
      text = "[3, 1e6]";
    } else {
      const std::vector<double> before = numbers_of(config, parameter);
      // The cells must fit into the map.
      text = before.empty() ? "2" : before.front() < 1.0 ? "0.5" : "19";
    }
    set_parameter(config, parameter.name, text);
    EXPECT_EQ(text_of(config, parameter), text) << parameter.name;
  }
}

TEST(TextOf, WritesNumbersShortAndWithoutLoss) {
  const auto text = [](double number) {
    Config config;
    config.paper_only.min_variance_threshold = number;
    for (const Parameter& parameter : parameters())
      if (parameter.name == "min_variance_threshold") return text_of(config, parameter);
    return std::string();
  };
  EXPECT_EQ(text(0.0), "0");
  EXPECT_EQ(text(0.33), "0.33");
  EXPECT_EQ(text(-10.0), "-10");
  EXPECT_EQ(text(5e-5), "5e-5");
  EXPECT_EQ(text(-1e6), "-1e6");
  EXPECT_EQ(text(1.25e-10), "1.25e-10");
  EXPECT_EQ(text(1e120), "1e120");
  EXPECT_EQ(std::stod(text(1.0 / 3.0)), 1.0 / 3.0);
}

std::string complaint_about(std::string_view name, std::string_view value) {
  Config config;
  try {
    set_parameter(config, name, value);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "no complaint";
}

TEST(SetParameter, RejectsWhatIsNoValueAndNamesTheField) {
  for (const auto& [name, value] : std::initializer_list<std::pair<const char*, const char*>>{
           {"resolution_m", ""},
           {"resolution_m", "abc"},
           {"resolution_m", "0.3m"},
           {"resolution_m", " 0.3"},
           {"resolution_m", "nan"},
           {"resolution_m", "inf"},
           {"resolution_m", "none"},
           {"resolution_m", "-1"},
           {"own_variance_min_points", "2.5"},
           {"own_variance_min_points", "-1"},
           {"own_variance_min_points", "1e300"},
           {"anchor_m", "1"},
           {"anchor_m", "1,2,3"},
           {"anchor_m", "1,"},
           {"anchor_m", "[1,2"},
           {"ego_vehicle_box_m", "1,-1,-1,1,-1,1"},
           {"sensor_height_m", "None"},
           {"sensor_height_m", "1000"},
           {"method", "ours"},
           {"method", "2"}}) {
    EXPECT_NE(complaint_about(name, value).find(name), std::string::npos)
        << name << " = '" << value << "': " << complaint_about(name, value);
  }
}

TEST(SetParameter, RejectsUnknownNames) {
  EXPECT_NE(complaint_about("cell_size", "0.3").find("cell_size"), std::string::npos);
  EXPECT_NE(complaint_about("", "0.3").find("unknown"), std::string::npos);
}

TEST(SetParameter, SaysWhatThereIsInsteadOfAFormerName) {
  EXPECT_NE(complaint_about("cell_size_m", "0.3").find("it is resolution_m now"),
            std::string::npos);
  EXPECT_NE(complaint_about("own_vehicle_min_x_m", "-1").find("ego_vehicle_box_m"),
            std::string::npos);
  EXPECT_NE(complaint_about("surface_step_m", "0.3").find("constant"), std::string::npos);
}

TEST(SetParameter, LeavesTheConfigAsItWasIfItThrows) {
  Config config;
  EXPECT_THROW(set_parameter(config, "resolution_m", "-1"), std::invalid_argument);
  EXPECT_EQ(config.map.resolution_m, Config{}.map.resolution_m);
}

}  // namespace
}  // namespace groundgrid
