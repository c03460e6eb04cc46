#pragma once

#include <nanobind/nanobind.h>

#include <string>

#include "groundgrid/config.hpp"
#include "groundgrid/parameters.hpp"

namespace groundgrid::python {

namespace nb = nanobind;

/// float, int, str, a tuple of floats or None.
nb::object value_of(const Config& config, const Parameter& parameter);

/// Sets a field without a look at its range. Throws TypeError, with the name, where the value is of
/// another type.
void set_value(Config& config, const Parameter& parameter, nb::handle value);

/// The configuration with other values by name, as keyword arguments bring them. Throws TypeError
/// where there is no such name and ValueError where a value is out of range.
Config with_values(Config config, const nb::dict& values);

/// "float", "float | None", "int", "str".
std::string type_name(const Parameter& parameter);

/// ", *, method: str = 'standard', ...": all parameters, as a signature in a stub has them.
/// Without defaults they are "... = ...", for functions that leave alone what is not given.
std::string keyword_signature(bool with_defaults);

}  // namespace groundgrid::python
