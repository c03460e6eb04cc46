#include "program/method_options.hpp"

#include <fmt/format.h>

#include <CLI/Validators.hpp>
#include <algorithm>
#include <optional>
#include <type_traits>
#include <variant>

#include "groundgrid/parameters.hpp"
#include "program/parameter_values.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

Json value_of(const Config& config, const Parameter& parameter) {
  return std::visit(
      [&config](auto member) -> Json {
        const auto& value = config.*member;
        if constexpr (std::is_same_v<std::decay_t<decltype(value)>, std::optional<double>>)
          return value ? Json(*value) : Json(nullptr);
        else if constexpr (std::is_same_v<std::decay_t<decltype(value)>, Method>)
          return name_of(value);
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
  ParameterValues values = file_.empty() ? ParameterValues(values_.size()) : values_in(file_);
  for (std::size_t i = 0; i < values.size(); ++i)
    if (parameter_options_[i]->count() > 0) values[i] = GivenValue{values_[i]};
  set_values(values, config);
  return config;
}

Json to_json(const Config& config) {
  Json json;
  for (const Parameter& parameter : parameters())
    json[std::string(parameter.name)] = value_of(config, parameter);
  return json;
}

}  // namespace groundgrid::program
