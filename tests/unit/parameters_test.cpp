#include "groundgrid/parameters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <stdexcept>
#include <string>
#include <type_traits>

namespace groundgrid {
namespace {

/// Stands for a value of any field of Config in an aggregate initialisation.
struct AnyNumber {
  template <typename T>
  requires(std::is_arithmetic_v<T> || std::is_enum_v<T>) operator T()
      const {  // NOLINT(google-explicit-constructor)
    return {};
  }
};

/// The number of fields of an aggregate: how many initialisers it takes at most.
template <typename Aggregate, typename... Values>
constexpr std::size_t count_fields() {
  if constexpr (requires { Aggregate{Values{}..., AnyNumber{}}; })
    return count_fields<Aggregate, Values..., AnyNumber>();
  else
    return sizeof...(Values);
}

struct ThreeFields {
  double a = 0.0;
  std::optional<double> b{};
  bool c = false;
};
static_assert(count_fields<ThreeFields>() == 3);

std::ptrdiff_t offset_of(const Parameter& parameter) {
  static const Config config;
  const auto* begin = reinterpret_cast<const std::byte*>(&config);
  return std::visit(
      [&](auto member) { return reinterpret_cast<const std::byte*>(&(config.*member)) - begin; },
      parameter.member);
}

double value_of(const Config& config, const Parameter& parameter) {
  return std::visit(
      [&](auto member) -> double {
        if constexpr (std::same_as<decltype(member), std::optional<double> Config::*>)
          return (config.*member).value_or(parameter.min);
        else
          return static_cast<double>(config.*member);
      },
      parameter.member);
}

TEST(Parameters, TableHasEveryFieldOfConfigOnceAndInOrder) {
  EXPECT_EQ(parameters().size(), count_fields<Config>());
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
      EXPECT_GE(value_of(config, parameter), parameter.min) << parameter.name;
      EXPECT_LE(value_of(config, parameter), parameter.max) << parameter.name;
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
    // "  double cell_size_m = 0.33;" or "  std::optional<double> sensor_height_m{};"
    const std::string declaration = line.substr(0, std::min(line.find(" = "), line.find("{}")));
    comments[declaration.substr(declaration.rfind(' ') + 1)] = comment;
    comment.clear();
  }
  return comments;
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
  set_parameter(config, "cell_size_m", "0.25");
  set_parameter(config, "sensor_height_m", "1.73");
  set_parameter(config, "method", "paper");
  set_parameter(config, "own_variance_min_points", "7");
  EXPECT_EQ(config.cell_size_m, 0.25);
  EXPECT_EQ(config.sensor_height_m, 1.73);
  EXPECT_EQ(config.own_variance_min_points, 7);
  EXPECT_EQ(config.method, Method::paper);
  set_parameter(config, "sensor_height_m", "none");
  set_parameter(config, "own_variance_min_points", "10");
  set_parameter(config, "method", "standard");
  EXPECT_FALSE(config.sensor_height_m.has_value());
  EXPECT_EQ(config.method, Method::standard);
}

TEST(SetParameter, ReachesEveryField) {
  for (const Parameter& parameter : parameters()) {
    Config config;
    if (std::holds_alternative<Method Config::*>(parameter.member)) continue;
    if (parameter.group == "paper") config.method = Method::paper;
    const double before = value_of(config, parameter);
    // The cells must fit into the map: those two are only moved a little.
    const bool map_size = parameter.name == "map_extent_m" || parameter.name == "cell_size_m";
    const double other = map_size                     ? before * 2
                         : before == parameter.max    ? parameter.min
                         : before < parameter.max - 1 ? before + 1
                                                      : parameter.max;
    set_parameter(config, parameter.name, std::to_string(other));
    EXPECT_NEAR(value_of(config, parameter), other, 1e-6) << parameter.name;
  }
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
  for (const auto& [name, value] :
       std::initializer_list<std::pair<const char*, const char*>>{{"cell_size_m", ""},
                                                                  {"cell_size_m", "abc"},
                                                                  {"cell_size_m", "0.3m"},
                                                                  {"cell_size_m", " 0.3"},
                                                                  {"cell_size_m", "nan"},
                                                                  {"cell_size_m", "inf"},
                                                                  {"cell_size_m", "none"},
                                                                  {"cell_size_m", "-1"},
                                                                  {"threads", "2.5"},
                                                                  {"threads", "-1"},
                                                                  {"threads", "1e300"},
                                                                  {"threads", "true"},
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

TEST(SetParameter, LeavesTheConfigAsItWasWhereItThrows) {
  Config config;
  EXPECT_THROW(set_parameter(config, "cell_size_m", "-1"), std::invalid_argument);
  EXPECT_EQ(config.cell_size_m, Config{}.cell_size_m);
}

}  // namespace
}  // namespace groundgrid
