#include "groundgrid/config.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>

#include "groundgrid/parameters.hpp"

namespace groundgrid {
namespace {

std::optional<double> value_of(const Config& config, const Parameter& parameter) {
  if (const auto* number = std::get_if<double Config::*>(&parameter.member))
    return config.*(*number);
  if (const auto* optional = std::get_if<std::optional<double> Config::*>(&parameter.member))
    return config.*(*optional);
  if (const auto* whole = std::get_if<int Config::*>(&parameter.member))
    return static_cast<double>(config.*(*whole));
  return std::nullopt;
}

}  // namespace

Config Config::paper() {
  Config config;
  config.method = Method::paper;
  // Section IV-A, in its order; all of it, so that a change of the default changes nothing here.
  config.cell_size_m = 0.33;
  config.variance_distance_factor = 1e-5;
  config.min_variance_threshold = 5e-5;
  config.confidence_decay = 5.0;
  config.min_point_fraction = 0.25;
  config.outlier_min_confidence = 1.25;
  config.ground_threshold_m = 0.3;
  config.obstacle_threshold_m = 0.1;
  config.confidence_point_scale = 20.0;
  config.outlier_tolerance_m = 0.1;
  config.patch_change_distance_m = 20.0;
  config.point_angle_deg = 0.4;
  config.own_variance_min_points = 10;
  return config;
}

void Config::validate() const {
  for (const Parameter& parameter : parameters()) {
    const std::optional<double> value = value_of(*this, parameter);
    if (!value || (*value >= parameter.min && *value <= parameter.max)) continue;
    std::ostringstream message;
    message << parameter.name << " = " << *value << ": must be between " << parameter.min << " and "
            << parameter.max;
    throw std::invalid_argument(message.str());
  }
  if (method == Method::paper && max_step_m > 0.0)
    throw std::invalid_argument(
        "max_step_m: the paper's method knows no steps; leave it at 0, or set method = standard");
  if (map_extent_m / cell_size_m > 4096.0 || map_extent_m < 9.0 * cell_size_m)
    throw std::invalid_argument(
        "map_extent_m: the map must be 9 to 4096 cells wide (a cell takes some 130 bytes); choose "
        "another cell_size_m");
}

}  // namespace groundgrid
