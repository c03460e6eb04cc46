#include "simulation/sensor_fields.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <sstream>
#include <toml.hpp>
#include <utility>

#include "io/error.hpp"
#include "io/number_list.hpp"

namespace groundgrid::simulation {
namespace {

constexpr std::string_view kNameLetters = "abcdefghijklmnopqrstuvwxyz0123456789_";

/// A line without comment and blanks around it, and without what is no ASCII: toml11 3.7 reads
/// beyond its buffer where a string is not UTF-8. No word that a field takes has a # in it.
std::string tidied(std::string_view line) {
  line = line.substr(0, line.find('#'));
  const auto begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  std::string text(line.substr(begin, line.find_last_not_of(" \t") - begin + 1));
  std::replace_if(
      text.begin(), text.end(), [](char c) { return (c & 0x80) != 0; }, '?');
  return text;
}

bool is_open(const std::string& entry) {
  return entry.find('[') != std::string::npos && entry.find(']') == std::string::npos;
}

std::string name_in(const std::string& entry) {
  return entry.substr(0, entry.find_first_not_of(kNameLetters));
}

std::optional<double> number_in(const toml::value& value) {
  if (value.is_integer()) return static_cast<double>(value.as_integer());
  if (value.is_floating()) return value.as_floating();
  return std::nullopt;
}

std::optional<std::vector<double>> numbers_in(const toml::array& array) {
  std::vector<double> numbers;
  for (const toml::value& element : array) {
    const std::optional<double> number = number_in(element);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

}  // namespace

SensorFields::SensorFields(std::string_view text, std::filesystem::path file)
    : file_(std::move(file)) {
  std::string entry;
  std::size_t first = 0;
  std::size_t number = 0;
  for (const std::string_view line : io::split_lines(text)) {
    ++number;
    const std::string tidy = tidied(line);
    if (tidy.empty()) continue;
    if (entry.empty()) first = number;
    entry += tidy + '\n';
    if (is_open(entry)) continue;
    add(entry, first);
    entry.clear();
  }
  if (!entry.empty()) fail_line(first, "a list that ends with ]", entry);
}

void SensorFields::add(const std::string& entry, std::size_t line) {
  const std::string name = name_in(entry);
  // Without tables and nested lists toml11 does not call itself, however long the text is.
  if (name.empty() || entry.find_first_not_of(" \t", name.size()) != entry.find('=') ||
      std::count(entry.begin(), entry.end(), '[') > 1 || entry.find('{') != std::string::npos)
    fail_line(line, "name = a number, a quoted word or a list of numbers", entry);
  if (fields_.contains(name)) fail_line(line, "each field once", name);
  fields_[name] = {line, value_in(entry, line)};
}

SensorFields::Value SensorFields::value_in(const std::string& entry, std::size_t line) const {
  try {
    std::istringstream text(entry);
    const toml::value document = toml::parse(text);
    const toml::value& value = document.as_table().begin()->second;
    if (value.is_string()) return value.as_string().str;
    if (const auto number = number_in(value)) return *number;
    if (value.is_array())
      if (auto numbers = numbers_in(value.as_array())) return std::move(*numbers);
  } catch (const toml::exception&) {
    fail_line(line, "TOML", entry);
  }
  fail_line(line, "a number, a quoted word or a list of numbers", entry);
}

template <typename Kind>
const Kind* SensorFields::take(const std::string& name, const std::string& expected) {
  const auto found = fields_.find(name);
  if (found == fields_.end()) return nullptr;
  found->second.taken = true;
  const Kind* const value = std::get_if<Kind>(&found->second.value);
  if (value == nullptr) fail(name, expected, "something else");
  return value;
}

std::optional<std::string> SensorFields::word(const std::string& name) {
  const auto* const value = take<std::string>(name, "a quoted word");
  return value != nullptr ? std::optional(*value) : std::nullopt;
}

std::optional<double> SensorFields::number(const std::string& name, Limits range) {
  const auto* const value = take<double>(name, "a number");
  if (value == nullptr) return std::nullopt;
  require_range(name, *value, range);
  return *value;
}

std::optional<std::vector<double>> SensorFields::numbers(const std::string& name, Limits range) {
  const auto* const values = take<std::vector<double>>(name, "a list of numbers");
  if (values == nullptr) return std::nullopt;
  for (const double value : *values) require_range(name, value, range);
  return *values;
}

void SensorFields::require_range(const std::string& name, double value, Limits range) const {
  if (value >= range.least && value <= range.greatest) return;
  fail(name, fmt::format("{} to {}", range.least, range.greatest), fmt::format("{}", value));
}

void SensorFields::require_all_taken() const {
  for (const auto& [name, field] : fields_)
    if (!field.taken) fail_line(field.line, "a field of a sensor", name);
}

void SensorFields::fail(const std::string& name, const std::string& expected,
                        const std::string& got) const {
  const auto found = fields_.find(name);
  io::ErrorDetails details{.file = file_, .expected = name + ": " + expected, .got = got};
  if (found != fields_.end()) details.line = found->second.line;
  throw io::Error(details);
}

void SensorFields::fail_line(std::size_t line, const std::string& expected,
                             std::string_view got) const {
  throw io::Error({.file = file_,
                   .line = line,
                   .expected = expected,
                   .got = io::in_quotes(got.substr(0, got.find('\n')))});
}

}  // namespace groundgrid::simulation
