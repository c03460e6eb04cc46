#include "groundgrid/config.hpp"

#include <sstream>
#include <stdexcept>
#include <string>

#include "groundgrid/parameters.hpp"

namespace groundgrid {
namespace {

void check_ranges(const Config& config) {
  for (const Parameter& parameter : parameters()) {
    for (const double number : numbers_of(config, parameter)) {
      if (number >= parameter.min && number <= parameter.max) continue;
      std::ostringstream message;
      message << parameter.name << " = " << number << ": must be between " << parameter.min
              << " and " << parameter.max;
      throw std::invalid_argument(message.str());
    }
  }
}

/// A value that the chosen method ignores is a mistake of whoever set it.
void check_method(const Config& config) {
  if (config.method == Method::paper) {
    if (config.labels.max_step_m > 0.0)
      throw std::invalid_argument(
          "max_step_m: the paper's method knows no steps; leave it at 0, or set method = standard");
    return;
  }
  static const Config defaults;
  for (const Parameter& parameter : parameters())
    if (parameter.group == "paper" &&
        numbers_of(config, parameter) != numbers_of(defaults, parameter))
      throw std::invalid_argument(std::string(parameter.name) +
                                  ": only the paper's method has it; set method = paper, or leave "
                                  "it at its default");
}

void check_box(const std::optional<Box>& box) {
  for (std::size_t axis = 0; box && axis < 3; ++axis)
    if (!((*box)[2 * axis] < (*box)[2 * axis + 1]))
      throw std::invalid_argument(
          "ego_vehicle_box_m: each least value must be below the greatest: min x, max x, min y, "
          "max y, min z, max z");
}

}  // namespace

Config Config::paper() {
  Config config;
  config.method = Method::paper;
  // The rest of section IV-A is in the fields that our method shares or does not have.
  config.labels.ground_threshold_m = 0.3;
  return config;
}

void Config::validate() const {
  check_ranges(*this);
  check_method(*this);
  check_box(vehicle.ego_vehicle_box_m);
  if (map.extent_m / map.resolution_m > 4096.0 || map.extent_m < 9.0 * map.resolution_m)
    throw std::invalid_argument(
        "extent_m: the map must be 9 to 4096 cells wide (a cell takes some 130 bytes); choose "
        "another resolution_m");
}

}  // namespace groundgrid
