#include <fmt/format.h>

#include "groundgrid/parameters.hpp"
#include "program/parameter_listing.hpp"
#include "program/parameter_words.hpp"
#include "program/version.hpp"

namespace groundgrid::program {
namespace {

std::string comment_of(const Parameter& parameter) {
  std::string text = fmt::format("# {}\n# ", parameter.text);
  if (!parameter.unit.empty()) text += fmt::format("{}, ", parameter.unit);
  text += range_word(parameter);
  if (is_optional(parameter)) text += ", or \"none\"";
  if (!parameter.symbol.empty()) text += fmt::format("; the paper's {}", parameter.symbol);
  return text + "\n";
}

}  // namespace

std::string parameter_toml(const Config& config, std::string_view preset) {
  std::string text = fmt::format(
      "# Parameters of GroundGrid {}, preset {}, for --config. Lines left out, or begun with '#',\n"
      "# leave a parameter as --preset has it.\n",
      version(), preset);
  for (const Parameter& parameter : parameters()) {
    if (begins_stage(parameter)) text += fmt::format("\n# == {}\n", stage_heading(parameter));
    const std::string value = text_of(config, parameter);
    const bool quoted = is_name(parameter) || value == "none";
    text += fmt::format("\n{}{}{} = {}\n", comment_of(parameter), value == "none" ? "# " : "",
                        parameter.name, quoted ? fmt::format("\"{}\"", value) : value);
  }
  return text;
}

}  // namespace groundgrid::program
