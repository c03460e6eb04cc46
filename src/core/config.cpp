#include "groundgrid/config.hpp"

#include <cmath>
#include <sstream>
#include <stdexcept>
#include <string>

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

/// A value that the chosen method ignores is a mistake of whoever set it.
void check_method(const Config& config) {
  if (config.method == Method::paper) return;
  static const Config defaults;
  for (const Parameter& parameter : parameters())
    if (parameter.group == "paper" && value_of(config, parameter) != value_of(defaults, parameter))
      throw std::invalid_argument(std::string(parameter.name) +
                                  ": only the paper's method has it; set method = paper, or leave "
                                  "it at its default");
}

}  // namespace

Config Config::paper() {
  Config config;
  config.method = Method::paper;
  // The rest of section IV-A is in the fields that our method shares or does not have.
  config.ground_threshold_m = 0.3;
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
  check_method(*this);
  if (method == Method::paper && max_step_m > 0.0)
    throw std::invalid_argument(
        "max_step_m: the paper's method knows no steps; leave it at 0, or set method = standard");
  if (map_extent_m / cell_size_m > 4096.0 || map_extent_m < 9.0 * cell_size_m)
    throw std::invalid_argument(
        "map_extent_m: the map must be 9 to 4096 cells wide (a cell takes some 130 bytes); choose "
        "another cell_size_m");
}

}  // namespace groundgrid
