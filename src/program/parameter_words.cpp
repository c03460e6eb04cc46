#include "program/parameter_words.hpp"

#include <fmt/format.h>

#include <array>
#include <charconv>
#include <optional>
#include <type_traits>
#include <utility>
#include <variant>

namespace groundgrid::program {
namespace {

using Stage = std::pair<std::string_view, std::string_view>;

constexpr std::array kHeadings{
    Stage{"method", "Method"},
    Stage{"map", "Map"},
    Stage{"vehicle", "Vehicle and sensor"},
    Stage{"labels", "Labels (III-F)"},
    Stage{"confidence", "Confidence of the map (III-D, III-E)"},
    Stage{"paper", "Of the paper's method alone"},
    Stage{"execution", "Execution"},
};

std::string word_of(double value) { return number_word(value); }
std::string word_of(int value) { return std::to_string(value); }
std::string word_of(Method value) { return std::string(name_of(value)); }
std::string word_of(const std::optional<double>& value) {
  return value ? number_word(*value) : "none";
}

}  // namespace

std::string number_word(double number) {
  std::array<char, 32> letters{};
  char* const end = std::to_chars(letters.data(), letters.data() + letters.size(), number).ptr;
  std::string word(letters.data(), end);
  // to_chars writes exponents with a sign and two digits.
  const auto exponent = word.find('e');
  if (exponent == std::string::npos) return word;
  if (word[exponent + 2] == '0') word.erase(exponent + 2, 1);
  if (word[exponent + 1] == '+') word.erase(exponent + 1, 1);
  return word;
}

std::string value_word(const Config& config, const Parameter& parameter) {
  return std::visit([&config](auto member) { return word_of(config.*member); }, parameter.member);
}

std::string range_word(const Parameter& parameter) {
  if (std::holds_alternative<Method Config::*>(parameter.member))
    return "standard, paper, reference";
  return fmt::format("{} to {}", number_word(parameter.min), number_word(parameter.max));
}

bool is_optional(const Parameter& parameter) {
  return std::holds_alternative<std::optional<double> Config::*>(parameter.member);
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
