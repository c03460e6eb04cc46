#include "program/method_options.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <variant>

#include "groundgrid/parameters.hpp"
#include "program/parameter_file.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const Config& config, const Parameter& parameter) {
  return std::visit(
      [&config](auto member) -> Json {
        const auto& value = config.*member;
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
          return value ? Json(*value) : Json(nullptr);
        else
          return value;
      },
      parameter.member);
}

std::string flag_of(const Parameter& parameter) {
  std::string flag = "--" + std::string(parameter.name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string group_of(const Parameter& parameter) {
  std::string group = "Method: " + std::string(parameter.group);
  std::replace(group.begin(), group.end(), '_', ' ');
  return group;
}

std::string description_of(const Parameter& parameter) {
  const Json value = value_of(Config{}, parameter);
  const std::string unit = parameter.unit.empty() ? "" : fmt::format(" {}", parameter.unit);
  return fmt::format("{} [{}{}]", parameter.text, value.is_null() ? "none" : value.dump(),
                     value.is_null() ? "" : unit);
}

const Parameter& parameter_named(const FileParameter& given) {
  std::string name = given.name;
  std::replace(name.begin(), name.end(), '-', '_');
  for (const Parameter& parameter : parameters())
    if (parameter.name == name) return parameter;
  throw UsageError(fmt::format("{}: unknown parameter '{}'", given.place, given.name));
}

// A value and what to begin a message about it with: its place in the parameter file, or nothing.
struct GivenValue {
  std::string text;
  std::string place{};
};

// What stands for each of parameters(), in their order; nothing where the value is left alone.
using Values = std::vector<std::optional<GivenValue>>;

void set_value(Config& config, const Parameter& parameter, const GivenValue& value) {
  try {
    set_parameter(config, parameter.name, value.text);
  } catch (const std::invalid_argument& error) {
    throw UsageError(value.place + error.what());
  }
}

Values values_in(const std::string& file) {
  Values values(parameters().size());
  for (FileParameter& given : read_parameter_file(file)) {
    const Parameter& parameter = parameter_named(given);
    auto& value = values[static_cast<std::size_t>(&parameter - parameters().data())];
    if (value)
      throw UsageError(fmt::format("{}: {} is given for the second time", given.place, given.name));
    value = GivenValue{std::move(given.value), given.place + ": "};
  }
  return values;
}

}  // namespace

void MethodOptions::add_to(CLI::App& command) {
  other_options_ = {
      command
          .add_option("--preset", preset_, "Start from these values: default or paper [default]")
          ->check(CLI::IsMember({"default", "paper"})),
      command.add_option("--config", file_,
                         "TOML file of parameters (name = value); flags win over it"),
      command.add_flag("--single-scan", single_scan_,
                       "Forget the map before each scan and use no poses")};
  values_.resize(parameters().size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Parameter& parameter = parameters()[i];
    parameter_options_.push_back(
        command.add_option(flag_of(parameter), values_[i], description_of(parameter))
            ->type_name("VALUE")
            ->group(group_of(parameter)));
  }
}

void MethodOptions::exclude(CLI::Option* other) {
  for (CLI::Option* option : parameter_options_) other->excludes(option);
  for (CLI::Option* option : other_options_) other->excludes(option);
}

Config MethodOptions::config() const {
  Config config = preset_ == "paper" ? Config::paper() : Config{};
  Values values = file_.empty() ? Values(values_.size()) : values_in(file_);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (parameter_options_[i]->count() > 0) values[i] = GivenValue{values_[i]};
  for (std::size_t i = 0; i < values.size(); ++i)
    if (values[i]) set_value(config, parameters()[i], *values[i]);
  try {
    config.validate();
  } catch (const std::invalid_argument& error) {
    throw UsageError(error.what());
  }
  return config;
}

Json to_json(const Config& config) {
  Json json;
  for (const Parameter& parameter : parameters())
    json[std::string(parameter.name)] = value_of(config, parameter);
  return json;
}

}  // namespace groundgrid::program
