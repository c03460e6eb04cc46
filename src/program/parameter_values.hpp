#pragma once

#include <optional>
#include <string>
#include <vector>

#include "groundgrid/config.hpp"
#include "groundgrid/parameters.hpp"

namespace groundgrid::program {

/// A value and what to begin a message about it with: its place in the parameter file, or nothing.
struct GivenValue {
  std::string text;
  std::string place{};
};

/// What stands for each of parameters(), in their order; nothing where the value is left alone.
using ParameterValues = std::vector<std::optional<GivenValue>>;

/// What a parameter file has (see read_parameter_file). Throws UsageError, with the line, also
/// where a parameter is unknown or given twice.
ParameterValues values_in(const std::string& file);

/// Sets the values that are given. Throws UsageError, with their place, where they are of another
/// type, out of range, or do not go together.
void set_values(const ParameterValues& values, Config& config);

/// Both in one go.
void apply_parameter_file(const std::string& file, Config& config);

}  // namespace groundgrid::program
