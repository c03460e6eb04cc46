#include "program/parameter_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <sstream>
#include <string_view>
#include <toml.hpp>
#include <utility>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "program/usage_error.hpp"

namespace groundgrid::program {
namespace {

/// All parameters with a comment each are a tenth of it.
constexpr std::size_t kMaxFileBytes = 65536;
/// toml11 follows nested arrays and tables by recursion: what fits into this goes well.
constexpr std::size_t kMaxLineBytes = 500;
constexpr std::size_t kMaxShownBytes = 60;
constexpr std::string_view kBlanks = " \t";
constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(kBlanks);
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(kBlanks) - begin + 1);
}

std::string shortened(std::string_view text) {
  return fmt::format("{}{}", text.substr(0, kMaxShownBytes),
                     text.size() > kMaxShownBytes ? "..." : "");
}

/// The sentence in toml11's message, which goes on with a picture of the line:
/// "[error] toml::parse_key: the sentence\n --> ...".
std::string sentence_of(const toml::exception& error) {
  std::string_view text = error.what();
  text = text.substr(0, text.find('\n'));
  for (const std::string_view before : {"[error] ", "toml::", "parse_"})
    if (text.starts_with(before)) text.remove_prefix(before.size());
  return std::string(text);
}

[[noreturn]] void fail_value(std::string_view line, const std::string& place,
                             const std::string& reason) {
  const auto equals = line.find('=');
  const std::string_view name = trimmed(line.substr(0, equals));
  if (name.empty() || equals == std::string_view::npos)
    throw UsageError(fmt::format("{}: expected name = value, got '{}'", place, shortened(line)));
  const std::string_view text = trimmed(line.substr(equals + 1));
  throw UsageError(fmt::format(
      "{}: {}: expected a number, a list of numbers or a quoted word, got {} ({})", place,
      shortened(name), text.empty() ? "nothing" : fmt::format("'{}'", shortened(text)), reason));
}

[[noreturn]] void fail_table(std::string_view line, const std::string& place) {
  throw UsageError(fmt::format("{}: {}: parameters stand at the top level, in no table", place,
                               shortened(line)));
}

toml::table table_in(std::string_view line, const std::string& place) {
  // toml11 3.7 reads beyond its buffer where a string is not UTF-8. No parameter needs more than
  // ASCII, and what stands in comments does not matter.
  std::string ascii(line);
  std::replace_if(
      ascii.begin(), ascii.end(), [](char c) { return (c & 0x80) != 0; }, '?');
  try {
    std::istringstream text(ascii);
    return toml::parse(text).as_table();
  } catch (const toml::exception& error) {
    fail_value(line, place, sentence_of(error));
  }
}

std::optional<std::string> text_of(const toml::value& value);

/// Nothing if the list holds anything but single values.
std::optional<std::string> list_text_of(const toml::array& list) {
  std::string text = "[";
  for (const toml::value& value : list) {
    const auto one = value.is_array() ? std::nullopt : text_of(value);
    if (!one) return std::nullopt;
    text += (text.size() > 1 ? ", " : "") + *one;
  }
  return text + "]";
}

std::optional<std::string> text_of(const toml::value& value) {
  switch (value.type()) {
    case toml::value_t::boolean:
      return value.as_boolean() ? "true" : "false";
    case toml::value_t::integer:
      return fmt::format("{}", value.as_integer());
    case toml::value_t::floating:
      return fmt::format("{}", value.as_floating());
    case toml::value_t::string:
      return value.as_string().str;
    case toml::value_t::array:
      return list_text_of(value.as_array());
    default:
      return std::nullopt;
  }
}

/// Nothing where the line is blank or a comment.
std::optional<FileParameter> parameter_in(std::string_view line, std::string place) {
  if (line.empty() || line.front() == '#') return std::nullopt;
  if (line.front() == '[') fail_table(line, place);
  if (line.size() > kMaxLineBytes)
    throw UsageError(fmt::format("{}: expected name = value in at most {} bytes, got {}: '{}'",
                                 place, kMaxLineBytes, line.size(), shortened(line)));
  const toml::table table = table_in(line, place);
  if (table.empty()) return std::nullopt;
  const auto& [name, value] = *table.begin();
  if (value.is_table()) fail_table(line, place);
  std::optional<std::string> text = text_of(value);
  if (!text) fail_value(line, place, toml::stringize(value.type()));
  return FileParameter{std::move(place), name, std::move(*text)};
}

std::string read_short_text(const std::string& path) {
  io::InputFile file(path);
  if (file.size() > kMaxFileBytes)
    throw io::Error({.file = path,
                     .expected = fmt::format("a parameter file of at most {} bytes", kMaxFileBytes),
                     .got = fmt::format("{} bytes", file.size())});
  std::string text;
  file.read_into(text, static_cast<std::size_t>(file.size()));
  return text;
}

}  // namespace

// Each line is parsed as a document of its own. So its number is known for every error, and a quote
// or bracket left open cannot take the lines after it.
std::vector<FileParameter> read_parameter_file(const std::string& path) {
  const std::string text = read_short_text(path);
  std::string_view lines = text;
  if (lines.starts_with(kByteOrderMark)) lines.remove_prefix(kByteOrderMark.size());
  std::vector<FileParameter> parameters;
  std::size_t number = 0;
  for (const std::string_view line : io::split_lines(lines)) {
    ++number;
    auto parameter = parameter_in(trimmed(line), fmt::format("{}, line {}", path, number));
    if (parameter) parameters.push_back(std::move(*parameter));
  }
  return parameters;
}

}  // namespace groundgrid::program
