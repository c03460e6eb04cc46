#include "groundgrid/parameters.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <stdexcept>
#include <string>

namespace groundgrid {
namespace {

constexpr double kFar = 1e6;

constexpr std::array kParameters{
    Parameter{"method", &Config::method, "", 0.0, 2.0, "", "method",
              "standard: ours, which grew out of the paper's; paper: the paper's to the letter; "
              "reference: the standard one as plain code, slowly and with the same bits."},
    // Map
    Parameter{"map_extent_m", &Config::map_extent_m, "m", 3.0, 2000.0, "", "map",
              "Side of the square map around the vehicle."},
    Parameter{"cell_size_m", &Config::cell_size_m, "m", 0.02, 10.0, "R", "map", "Side of a cell."},
    Parameter{"grid_anchor_x_m", &Config::grid_anchor_x_m, "m", -1e8, 1e8, "", "map",
              "Map frame x of a cell's centre; the first pose's where left out."},
    Parameter{"grid_anchor_y_m", &Config::grid_anchor_y_m, "m", -1e8, 1e8, "", "map",
              "Map frame y of a cell's centre; the first pose's where left out."},
    Parameter{"pose_jump_m", &Config::pose_jump_m, "m", 0.1, 1000.0, "", "map",
              "A move between two scans by more than this starts the map anew."},
    // Vehicle and sensor
    Parameter{"sensor_height_m", &Config::sensor_height_m, "m", -10.0, 100.0, "", "vehicle",
              "Height of the (first) sensor above the ground; estimated where left out and the "
              "scan brings no mounting."},
    Parameter{"min_range_m", &Config::min_range_m, "m", 0.0, 100.0, "", "vehicle",
              "Points nearer to their sensor are unknown and never enter the map."},
    Parameter{"own_vehicle_min_x_m", &Config::own_vehicle_min_x_m, "m", -100.0, 100.0, "",
              "vehicle", "Rear of the own vehicle's box in base; an empty box takes no point."},
    Parameter{"own_vehicle_max_x_m", &Config::own_vehicle_max_x_m, "m", -100.0, 100.0, "",
              "vehicle", "Front of the own vehicle's box in base."},
    Parameter{"own_vehicle_min_y_m", &Config::own_vehicle_min_y_m, "m", -100.0, 100.0, "",
              "vehicle", "Right side of the own vehicle's box in base."},
    Parameter{"own_vehicle_max_y_m", &Config::own_vehicle_max_y_m, "m", -100.0, 100.0, "",
              "vehicle", "Left side of the own vehicle's box in base."},
    Parameter{"own_vehicle_min_z_m", &Config::own_vehicle_min_z_m, "m", -100.0, 100.0, "",
              "vehicle", "Bottom of the own vehicle's box in base."},
    Parameter{"own_vehicle_max_z_m", &Config::own_vehicle_max_z_m, "m", -100.0, 100.0, "",
              "vehicle", "Top of the own vehicle's box in base."},
    // Labels
    Parameter{
        "ground_threshold_m", &Config::ground_threshold_m, "m", 0.0, 10.0, "h_g", "labels",
        "Greatest height of a ground point above the ground. The paper: h_g, in ground cells."},
    Parameter{"max_step_m", &Config::max_step_m, "m", 0.0, 10.0, "", "labels",
              "Steps of the ground higher than this, such as kerbs, are obstacles; 0: off. Not "
              "with the paper's method."},
    // Confidence
    Parameter{"confidence_point_scale", &Config::confidence_point_scale, "", 1e-3, 1e6, "s",
              "confidence", "Points in a patch for full confidence (eq. 4)."},
    Parameter{"confidence_decay", &Config::confidence_decay, "", 1.0, 1e9, "θ", "confidence",
              "Decay of confidence where a scan shows no ground (eq. 8)."},
    // Of the paper's method alone
    Parameter{"outlier_tolerance_m", &Config::outlier_tolerance_m, "m", 0.0, 10.0, "o_t", "paper",
              "A ray may dip this far below the map and still be free."},
    Parameter{"outlier_min_confidence", &Config::outlier_min_confidence, "", 1e-6, 25.0, "o_minc",
              "paper", "Sum of confidence over 5x5 cells that a cell needs to block a ray."},
    Parameter{"variance_distance_factor", &Config::variance_distance_factor, "m", 0.0, 1.0, "d_sf",
              "paper", "Variance threshold per metre of distance (eq. 1)."},
    Parameter{"min_variance_threshold", &Config::min_variance_threshold, "m²", 0.0, 1.0, "t_minv",
              "paper", "Least variance threshold."},
    Parameter{"point_angle_deg", &Config::point_angle_deg, "deg", 0.001, 90.0, "d_pv", "paper",
              "Angle between neighbouring points of a beam (eq. 2)."},
    Parameter{"min_point_fraction", &Config::min_point_fraction, "", 0.0, 100.0, "g_minp", "paper",
              "Share of the expected points that a cell needs."},
    Parameter{"patch_change_distance_m", &Config::patch_change_distance_m, "m", 0.0, kFar, "d_ps",
              "paper", "Patches are 3x3 nearer than this, 5x5 beyond."},
    Parameter{"own_variance_min_points", &Config::own_variance_min_points, "", 1.0, 1e6, "v_np",
              "paper", "From this count on a cell's own variance is used."},
    Parameter{"obstacle_threshold_m", &Config::obstacle_threshold_m, "m", 0.0, 10.0, "h_o", "paper",
              "Greatest height of a ground point in cells that are not ground."},
    // Execution
    Parameter{"threads", &Config::threads, "", 0.0, 1024.0, "", "execution",
              "Threads of the standard method, the others use one; 0 for one per core."},
};

[[noreturn]] void reject(const Parameter& parameter, std::string_view value,
                         std::string_view expected) {
  throw std::invalid_argument(std::string(parameter.name) + " = " + std::string(value) + ": " +
                              std::string(expected));
}

double number_from(const Parameter& parameter, std::string_view text) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value))
    reject(parameter, text, "not a number");
  return value;
}

Method method_from(const Parameter& parameter, std::string_view text) {
  for (const Method method : {Method::standard, Method::paper, Method::reference})
    if (text == name_of(method)) return method;
  reject(parameter, text, "must be standard, paper or reference");
}

int whole_number_from(const Parameter& parameter, std::string_view text) {
  const double value = number_from(parameter, text);
  if (value != std::floor(value) || std::abs(value) > 1e9)
    reject(parameter, text, "not a whole number");
  return static_cast<int>(value);
}

void assign(Config& config, const Parameter& parameter, std::string_view value) {
  if (const auto* member = std::get_if<double Config::*>(&parameter.member))
    config.*(*member) = number_from(parameter, value);
  else if (const auto* optional = std::get_if<std::optional<double> Config::*>(&parameter.member))
    config.*(*optional) =
        value == "none" ? std::nullopt : std::optional(number_from(parameter, value));
  else if (const auto* whole = std::get_if<int Config::*>(&parameter.member))
    config.*(*whole) = whole_number_from(parameter, value);
  else
    config.*std::get<Method Config::*>(parameter.member) = method_from(parameter, value);
}

}  // namespace

std::span<const Parameter> parameters() { return kParameters; }

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

void set_parameter(Config& config, std::string_view name, std::string_view value) {
  const auto parameter = std::find_if(kParameters.begin(), kParameters.end(),
                                      [name](const Parameter& p) { return p.name == name; });
  if (parameter == kParameters.end())
    throw std::invalid_argument("unknown parameter '" + std::string(name) + "'");
  Config changed = config;
  assign(changed, *parameter, value);
  changed.validate();
  config = changed;
}

}  // namespace groundgrid
