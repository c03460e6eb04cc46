#include "program/parameter_words.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

namespace groundgrid::program {
namespace {

using Stage = std::pair<std::string_view, std::string_view>;

constexpr std::array kHeadings{
    Stage{"method", "Method"},
    Stage{"map", "Map"},
    Stage{"vehicle", "Vehicle and sensor"},
    Stage{"labels", "Labels (III-F)"},
    Stage{"paper", "Of the paper's method alone"},
};

}  // namespace

std::string range_word(const Parameter& parameter) {
  if (is_name(parameter)) return "standard, paper, reference";
  return fmt::format("{} to {}", text_of(parameter.min), text_of(parameter.max));
}

std::string_view stage_heading(const Parameter& parameter) {
  for (const auto& [stage, heading] : kHeadings)
    if (stage == parameter.group) return heading;
  return parameter.group;
}

bool begins_stage(const Parameter& parameter) {
  return &parameter == parameters().data() || (&parameter - 1)->group != parameter.group;
}

}  // namespace groundgrid::program
