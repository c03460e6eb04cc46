#pragma once

#include <filesystem>
#include <string_view>

#include "simulation/sensors.hpp"

namespace groundgrid::simulation {

/// Reads the description of a sensor from TOML (docs/simulation.md lists its fields). `file` is
/// for messages; without its folder and extension it becomes the sensor's name.
///
/// Throws io::Error, with the line, where the text is no TOML of that kind, a field is unknown,
/// missing, given twice or out of its range, or the lists do not fit together.
Sensor parse_sensor(std::string_view text, const std::filesystem::path& file);

/// The same from a file. Throws io::Error also where it cannot be read or is larger than 64 KiB.
Sensor read_sensor(const std::filesystem::path& path);

}  // namespace groundgrid::simulation
