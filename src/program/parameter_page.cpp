#include <fmt/format.h>

#include "groundgrid/parameters.hpp"
#include "program/parameter_listing.hpp"
#include "program/parameter_words.hpp"

namespace groundgrid::program {
namespace {

constexpr std::string_view kIntroduction = R"(# Parameters

This page is what `groundgrid params --markdown` prints; a test compares the two.

Every parameter has one name in all places:

| where | how |
| --- | --- |
| C++ | a field of `groundgrid::Config`, in its part: `config.map.resolution_m = 0.25;` |
| command line | a flag: `--resolution-m 0.25` |
| file for `--config` | a line: `resolution_m = 0.25`; `groundgrid params --toml` prints such a file |

Flags win over the file, the file over `--preset`. The preset `default` is the best that we can
measure, `paper` follows the paper to the letter; values that differ are bold. What the values do is
in [method.md](method.md). A parameter whose value is "none" is left out.
)";

std::string row_of(const Parameter& parameter) {
  const std::string by_default = text_of(Config{}, parameter);
  std::string in_paper = text_of(Config::paper(), parameter);
  if (in_paper != by_default) in_paper = fmt::format("**{}**", in_paper);
  return fmt::format("| `{}` | {} | {} | {} | {} | {} | {} |\n", parameter.name, by_default,
                     in_paper, parameter.unit, range_word(parameter), parameter.symbol,
                     parameter.text);
}

}  // namespace

std::string parameter_page() {
  std::string text(kIntroduction);
  for (const Parameter& parameter : parameters()) {
    if (begins_stage(parameter))
      text += fmt::format(
          "\n## {}\n\n| parameter | default | paper | unit | range | symbol | meaning |\n"
          "| --- | --- | --- | --- | --- | --- | --- |\n",
          stage_heading(parameter));
    text += row_of(parameter);
  }
  return text;
}

}  // namespace groundgrid::program
