#include "program/parameter_values.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "program/parameter_file.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

const Parameter& parameter_named(const FileParameter& given) {
  std::string name = given.name;
  std::replace(name.begin(), name.end(), '-', '_');
  for (const Parameter& parameter : parameters())
    if (parameter.name == name) return parameter;
  try {
    Config any;
    set_parameter(any, name, "");
  } catch (const std::invalid_argument& error) {
    throw UsageError(fmt::format("{}: {}", given.place, error.what()));
  }
  throw UsageError(fmt::format("{}: unknown parameter '{}'", given.place, name));
}

void set_value(Config& config, const Parameter& parameter, const GivenValue& value) {
  try {
    set_parameter(config, parameter.name, value.text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(value.place + error.what());
  }
}

}  // namespace

ParameterValues values_in(const std::string& file) {
  ParameterValues values(parameters().size());
  for (FileParameter& given : read_parameter_file(file)) {
    const Parameter& parameter = parameter_named(given);
    auto& value = values[static_cast<std::size_t>(&parameter - parameters().data())];
    if (value)
      throw UsageError(fmt::format("{}: {} is given for the second time", given.place, given.name));
    value = GivenValue{std::move(given.value), given.place + ": "};
  }
  return values;
}

void set_values(const ParameterValues& values, Config& config) {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i]) set_value(config, parameters()[i], *values[i]);
  try {
    config.validate();
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
}

void apply_parameter_file(const std::string& file, Config& config) {
  set_values(values_in(file), config);
}

}  // namespace groundgrid::program
