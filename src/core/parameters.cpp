#include "groundgrid/parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <type_traits>
#include <utility>

namespace groundgrid {
namespace {

constexpr double kFar = 1e6;

// NOLINTNEXTLINE(cppcoreguidelines-macro-usage): a field's name once, in all of its uses.
#define GROUNDGRID_FIELD(part, name) \
#name, [](Config & config) -> Parameter::Field { return &config.part.name; }

constexpr std::array kParameters{
    Parameter{"method", [](Config& config) -> Parameter::Field { return &config.method; }, "", 0.0,
              2.0, "", "method",
              "standard: ours, which grew out of the paper's; paper: the paper's to the letter; "
              "reference: the standard one as plain code, slowly and with the same bits."},
    Parameter{GROUNDGRID_FIELD(map, extent_m), "m", 3.0, 2000.0, "", "map",
              "Side of the square map around the vehicle."},
    Parameter{GROUNDGRID_FIELD(map, resolution_m), "m", 0.02, 10.0, "R", "map", "Side of a cell."},
    Parameter{GROUNDGRID_FIELD(map, anchor_m), "m", -1e8, 1e8, "", "map",
              "Map frame x, y of a cell's centre; by default the first pose's."},
    Parameter{GROUNDGRID_FIELD(map, confidence_point_scale), "", 1e-3, 1e6, "s", "map",
              "Points in a patch for full confidence (eq. 4)."},
    Parameter{GROUNDGRID_FIELD(map, confidence_decay), "", 1.0, 1e9, "θ", "map",
              "Decay of confidence if a scan shows no ground (eq. 8)."},
    Parameter{GROUNDGRID_FIELD(vehicle, sensor_height_m), "m", -10.0, 100.0, "", "vehicle",
              "Height of the (first) sensor above the ground; estimated if left out and the scan "
              "brings no mounting."},
    Parameter{GROUNDGRID_FIELD(vehicle, min_range_m), "m", 0.0, 100.0, "", "vehicle",
              "Points nearer to their sensor are unknown and never enter the map."},
    Parameter{GROUNDGRID_FIELD(vehicle, ego_vehicle_box_m), "m", -100.0, 100.0, "", "vehicle",
              "Points in this box around the ego vehicle are unknown: min x, max x, min y, max y, "
              "min z, max z in base."},
    Parameter{
        GROUNDGRID_FIELD(labels, ground_threshold_m), "m", 0.0, 10.0, "h_g", "labels",
        "Greatest height of a ground point above the ground. The paper: h_g, in ground cells."},
    Parameter{GROUNDGRID_FIELD(labels, max_step_m), "m", 0.0, 10.0, "", "labels",
              "Steps of the ground higher than this, such as kerbs, are obstacles; 0: off. Not "
              "with the paper's method."},
    Parameter{GROUNDGRID_FIELD(paper_only, outlier_tolerance_m), "m", 0.0, 10.0, "o_t", "paper",
              "A ray may dip this far below the map and still be free."},
    Parameter{GROUNDGRID_FIELD(paper_only, outlier_min_confidence), "", 1e-6, 25.0, "o_minc",
              "paper", "Sum of confidence over 5x5 cells that a cell needs to block a ray."},
    Parameter{GROUNDGRID_FIELD(paper_only, variance_distance_factor), "m", 0.0, 1.0, "d_sf",
              "paper", "Variance threshold per metre of distance (eq. 1)."},
    Parameter{GROUNDGRID_FIELD(paper_only, min_variance_threshold), "m²", 0.0, 1.0, "t_minv",
              "paper", "Least variance threshold."},
    Parameter{GROUNDGRID_FIELD(paper_only, azimuth_resolution_deg), "deg", 0.001, 90.0, "d_pv",
              "paper", "Angle between neighbouring points of a beam (eq. 2)."},
    Parameter{GROUNDGRID_FIELD(paper_only, min_point_fraction), "", 0.0, 100.0, "g_minp", "paper",
              "Share of the expected points that a cell needs."},
    Parameter{GROUNDGRID_FIELD(paper_only, patch_change_distance_m), "m", 0.0, kFar, "d_ps",
              "paper", "Patches are 3x3 nearer than this, 5x5 beyond."},
    Parameter{GROUNDGRID_FIELD(paper_only, own_variance_min_points), "", 1.0, 1e6, "v_np", "paper",
              "From this count on a cell's own variance is used."},
    Parameter{GROUNDGRID_FIELD(paper_only, obstacle_threshold_m), "m", 0.0, 10.0, "h_o", "paper",
              "Greatest height of a ground point in cells that are not ground."},
};

#undef GROUNDGRID_FIELD

constexpr std::string_view kConstantNow = "it is a constant of the method now (docs/method.md)";

/// Names of earlier versions, and what there is now.
constexpr std::pair<std::string_view, std::string_view> kFormerNames[] = {
    {"map_extent_m", "it is extent_m now"},
    {"cell_size_m", "it is resolution_m now"},
    {"grid_anchor_x_m", "it is anchor_m = [x, y] now"},
    {"grid_anchor_y_m", "it is anchor_m = [x, y] now"},
    {"own_vehicle_min_x_m", "it is the 1st number of ego_vehicle_box_m now"},
    {"own_vehicle_max_x_m", "it is the 2nd number of ego_vehicle_box_m now"},
    {"own_vehicle_min_y_m", "it is the 3rd number of ego_vehicle_box_m now"},
    {"own_vehicle_max_y_m", "it is the 4th number of ego_vehicle_box_m now"},
    {"own_vehicle_min_z_m", "it is the 5th number of ego_vehicle_box_m now"},
    {"own_vehicle_max_z_m", "it is the 6th number of ego_vehicle_box_m now"},
    {"point_angle_deg", "it is azimuth_resolution_deg now"},
    {"paper_method", "it is method = \"paper\" now"},
    {"threads", "it is no parameter of the method now, but is given beside it (--threads)"},
    {"pose_jump_m", kConstantNow},
    {"outlier_min_depth_m", kConstantNow},
    {"max_cell_slope", kConstantNow},
    {"min_support_cells", kConstantNow},
    {"surface_block_m", kConstantNow},
    {"surface_tolerance_m", kConstantNow},
    {"surface_step_m", kConstantNow},
    {"plateau_area_m2", kConstantNow},
    {"plateau_height_m", kConstantNow},
    {"surface_min_confidence", kConstantNow},
    {"surface_follow_m", kConstantNow},
    {"tall_height_m", kConstantNow},
    {"overhang_height_m", kConstantNow},
    {"tall_min_share", kConstantNow},
    {"tall_threshold_m", kConstantNow},
    {"level_band_m", kConstantNow},
};

[[noreturn]] void reject(std::string_view name, std::string_view value, std::string_view expected) {
  throw std::invalid_argument(std::string(name) + " = " + std::string(value) + ": " +
                              std::string(expected));
}

[[noreturn]] void reject_name(std::string_view name) {
  const auto former = std::find_if(std::begin(kFormerNames), std::end(kFormerNames),
                                   [name](const auto& known) { return known.first == name; });
  std::string message = "unknown parameter '" + std::string(name) + "'";
  if (former != std::end(kFormerNames)) message += ": " + std::string(former->second);
  throw std::invalid_argument(message);
}

std::string_view without_blanks(std::string_view text) {
  const auto begin = text.find_first_not_of(' ');
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// Sets fields from text, each kind its own way.
struct Assign {
  std::string_view name;
  std::string_view text;

  void operator()(Method* method) const {
    for (const Method known : {Method::standard, Method::paper, Method::reference})
      if (text == name_of(known)) {
        *method = known;
        return;
      }
    reject(name, text, "must be standard, paper or reference");
  }

  void operator()(double* number) const { *number = number_in(text); }

  void operator()(int* number) const {
    const double value = number_in(text);
    if (value != std::floor(value) || std::abs(value) > 1e9) reject(name, text, "no whole number");
    *number = static_cast<int>(value);
  }

  template <typename Value>
  void operator()(std::optional<Value>* value) const {
    value->reset();
    if (text != "none") (*this)(&value->emplace());
  }

  template <std::size_t Count>
  void operator()(std::array<double, Count>* numbers) const {
    std::string_view rest = text;
    if (rest.starts_with('[') && rest.ends_with(']')) rest = rest.substr(1, rest.size() - 2);
    const auto commas = static_cast<std::size_t>(std::count(rest.begin(), rest.end(), ','));
    if (commas + 1 != Count)
      reject(name, text, "must be " + std::to_string(Count) + " numbers with commas between them");
    for (double& number : *numbers) {
      const auto end = std::min(rest.find(','), rest.size());
      number = number_in(without_blanks(rest.substr(0, end)));
      rest.remove_prefix(std::min(end + 1, rest.size()));
    }
  }

 private:
  [[nodiscard]] double number_in(std::string_view word) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc{} || end != word.data() + word.size() || !std::isfinite(value))
      reject(name, text, "not a number");
    return value;
  }
};

struct Numbers {
  std::vector<double> operator()(const Method* /*method*/) const { return {}; }
  std::vector<double> operator()(const int* number) const { return {static_cast<double>(*number)}; }
  std::vector<double> operator()(const double* number) const { return {*number}; }
  template <std::size_t Count>
  std::vector<double> operator()(const std::array<double, Count>* numbers) const {
    return {numbers->begin(), numbers->end()};
  }
  template <typename Value>
  std::vector<double> operator()(const std::optional<Value>* value) const {
    return *value ? (*this)(&**value) : std::vector<double>{};
  }
};

}  // namespace

std::span<const Parameter> parameters() { return kParameters; }

bool is_name(const Parameter& parameter) {
  Config config;
  return std::holds_alternative<Method*>(parameter.field(config));
}

bool is_optional(const Parameter& parameter) {
  Config config;
  return !is_name(parameter) && numbers_of(config, parameter).empty();
}

std::vector<double> numbers_of(const Config& config, const Parameter& parameter) {
  Config copy = config;
  return std::visit(Numbers{}, parameter.field(copy));
}

std::string_view name_of(Method method) {
  switch (method) {
    case Method::standard:
      return "standard";
    case Method::paper:
      return "paper";
    case Method::reference:
      return "reference";
  }
  return "";
}

std::string text_of(double number) {
  std::array<char, 32> letters{};
  char* const end = std::to_chars(letters.data(), letters.data() + letters.size(), number).ptr;
  std::string text(letters.data(), end);
  // to_chars writes exponents with a sign and two digits.
  const auto exponent = text.find('e');
  if (exponent == std::string::npos) return text;
  if (text[exponent + 2] == '0') text.erase(exponent + 2, 1);
  if (text[exponent + 1] == '+') text.erase(exponent + 1, 1);
  return text;
}

std::string text_of(const Config& config, const Parameter& parameter) {
  if (is_name(parameter)) return std::string(name_of(config.method));
  const std::vector<double> numbers = numbers_of(config, parameter);
  if (numbers.empty()) return "none";
  if (numbers.size() == 1) return text_of(numbers.front());
  std::string text = "[";
  for (const double number : numbers) text += (text.size() > 1 ? ", " : "") + text_of(number);
  return text + "]";
}

void set_parameter(Config& config, std::string_view name, std::string_view value) {
  const auto parameter = std::find_if(kParameters.begin(), kParameters.end(),
                                      [name](const Parameter& p) { return p.name == name; });
  if (parameter == kParameters.end()) reject_name(name);
  Config changed = config;
  std::visit(Assign{name, value}, parameter->field(changed));
  changed.validate();
  config = changed;
}

}  // namespace groundgrid
