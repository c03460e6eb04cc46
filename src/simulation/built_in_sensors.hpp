#pragma once

#include <span>
#include <string_view>

namespace groundgrid::simulation {

/// A file of src/simulation/sensors, which the build puts into the library.
struct BuiltInSensor {
  std::string_view name;
  std::string_view text;
};

std::span<const BuiltInSensor> built_in_sensors();

}  // namespace groundgrid::simulation
