#include "program/parameter_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string_view>

#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

constexpr std::string_view kBlanks = " \t";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

// A '#' between quotes begins no comment.
std::string_view without_comment(std::string_view line) {
  char quote = '\0';
  for (std::size_t i = 0; i < line.size(); ++i) {
    if (quote == '\0' && line[i] == '#') return line.substr(0, i);
    if (quote == '\0' && (line[i] == '"' || line[i] == '\''))
      quote = line[i];
    else if (line[i] == quote)
      quote = '\0';
  }
  return line;
}

bool may_stand_bare(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_' || letter == '-' || letter == '+' ||
         letter == '.';
}

// The text of one bare or quoted word; nothing where `text` is something else.
std::optional<std::string> word_in(std::string_view text) {
  if (text.size() >= 2 && (text.front() == '"' || text.front() == '\'') &&
      text.find(text.front(), 1) == text.size() - 1)
    return std::string(text.substr(1, text.size() - 2));
  if (text.empty() || !std::all_of(text.begin(), text.end(), may_stand_bare)) return std::nullopt;
  return std::string(text);
}

FileParameter parameter_in(std::string_view line, std::string place) {
  if (line.front() == '[')
    throw UsageError(
        fmt::format("{}: {}: parameters stand at the top level, in no table", place, line));
  const auto equals = line.find('=');
  const auto name = word_in(trimmed(line.substr(0, equals)));
  if (!name || equals == std::string_view::npos)
    throw UsageError(fmt::format("{}: expected name = value, got '{}'", place, line));
  const std::string_view text = trimmed(line.substr(equals + 1));
  const auto value = word_in(text);
  if (!value)
    throw UsageError(fmt::format("{}: {}: expected one number, true, false or quoted word, got {}",
                                 place, *name,
                                 text.empty() ? "nothing" : fmt::format("'{}'", text)));
  return {std::move(place), *name, *value};
}

}  // namespace

std::vector<FileParameter> read_parameter_file(const std::string& path) {
  const std::string text = io::read_text(path);
  std::vector<FileParameter> parameters;
  std::size_t number = 0;
  for (const std::string_view whole : io::split_lines(text)) {
    ++number;
    const std::string_view line = trimmed(without_comment(whole));
    if (!line.empty())
      parameters.push_back(parameter_in(line, fmt::format("{}, line {}", path, number)));
  }
  return parameters;
}

}  // namespace groundgrid::program
