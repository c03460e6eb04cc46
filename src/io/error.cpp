#include "io/error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <system_error>
#include <utility>

namespace groundgrid::io {
namespace {

// The names of files and what stands in them may hold anything, but shall not steer a terminal.
bool is_control(char letter) {
  return static_cast<unsigned char>(letter) < ' ' || letter == '\x7f';
}

std::string sentence(const ErrorDetails& details) {
  std::string text = details.file.string();
  if (details.line) text += fmt::format(", line {}", *details.line);
  if (details.offset) text += fmt::format(", byte {}", *details.offset);
  text += fmt::format(": expected {}, got {}", details.expected, details.got);
  if (!details.remedy.empty()) text += fmt::format("; {}", details.remedy);
  std::replace_if(text.begin(), text.end(), is_control, '?');
  return text;
}

}  // namespace

Error::Error(ErrorDetails details)
    : std::runtime_error(sentence(details)), details_(std::move(details)) {}

std::string system_message(int error_number) {
  return std::generic_category().message(error_number);
}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t kLongest = 40;
  std::string shown(text.substr(0, kLongest));
  for (char& letter : shown)
    if (letter < ' ' || letter > '~') letter = '?';
  return fmt::format("'{}{}'", shown, text.size() > kLongest ? "..." : "");
}

}  // namespace groundgrid::io
