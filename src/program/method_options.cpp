#include "program/method_options.hpp"

#include <fmt/format.h>

#include <CLI/Error.hpp>
#include <CLI/Validators.hpp>
#include <algorithm>

#include "groundgrid/parameters.hpp"
#include "program/parameter_values.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

/// The group of options that --help does not list.
constexpr const char* kHidden = "";

Json value_of(const Config& config, const Parameter& parameter) {
  const std::string text = text_of(config, parameter);
  if (text == "none") return nullptr;
  return is_name(parameter) ? Json(text) : Json::parse(text);
}

std::string flag_of(const Parameter& parameter) {
  std::string flag = "--" + std::string(parameter.name);
  std::replace(flag.begin(), flag.end(), '_', '-');
  return flag;
}

std::string description_of(const Parameter& parameter) {
  const std::string value = text_of(Config{}, parameter);
  const bool has_unit = !parameter.unit.empty() && value != "none";
  return fmt::format("{} [{}{}{}]", parameter.text, value, has_unit ? " " : "",
                     has_unit ? parameter.unit : "");
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
                       "Forget the map before each scan and use no poses"),
      command.add_option("--threads", threads_, "Threads of the method; 0: one per core [1]")
          ->check(CLI::Range(0, 1024))};
  values_.resize(parameters().size());
  for (std::size_t i = 0; i < values_.size(); ++i) {
    const Parameter& parameter = parameters()[i];
    parameter_options_.push_back(
        command.add_option(flag_of(parameter), values_[i], description_of(parameter))
            ->type_name("VALUE")
            ->group(kHidden));
  }
  const auto show_all = [this] {
    for (CLI::Option* option : parameter_options_) option->group("Parameters of the method");
    throw CLI::CallForHelp();
  };
  command.add_flag_callback("--help-all", show_all,
                            "Print this with the parameters of the method, such as "
                            "--sensor-height-m or --resolution-m, and exit");
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
