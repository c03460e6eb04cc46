#include "program/params.hpp"

#include <CLI/Validators.hpp>
#include <memory>
#include <string>

#include "program/json_text.hpp"
#include "program/parameter_listing.hpp"
#include "program/standard_output.hpp"

namespace groundgrid::program {
namespace {

struct ParamsOptions {
  std::string preset = "default";
  bool toml = false;
  bool json = false;
  bool markdown = false;
};

void print_parameters(const ParamsOptions& options) {
  const Config config = options.preset == "paper" ? Config::paper() : Config{};
  if (options.markdown) return print_result(parameter_page());
  if (options.json) return print_result(to_text(parameter_json(config)));
  if (options.toml) return print_result(parameter_toml(config, options.preset));
  print_result(parameter_table(config, options.preset));
}

}  // namespace

void add_params(CLI::App& app) {
  CLI::App* const command = app.add_subcommand(
      "params", "List the method's parameters: values, units, ranges, the paper's symbols");
  const auto options = std::make_shared<ParamsOptions>();
  CLI::Option* const preset =
      command->add_option("--preset", options->preset, "Whose values: default or paper [default]")
          ->check(CLI::IsMember({"default", "paper"}));
  CLI::Option* const toml =
      command->add_flag("--toml", options->toml, "Print a parameter file for --config");
  CLI::Option* const json =
      command->add_flag("--json", options->json, "Print JSON")->excludes(toml);
  command->add_flag("--markdown", options->markdown, "Print docs/parameters.md, with both presets")
      ->excludes(toml)
      ->excludes(json)
      ->excludes(preset);
  command->callback([options] { print_parameters(*options); });
}

}  // namespace groundgrid::program
