#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstddef>
#include <tuple>
#include <vector>

#include "groundgrid/parameters.hpp"
#include "program/parameter_listing.hpp"
#include "program/parameter_words.hpp"

namespace groundgrid::program {
namespace {

constexpr std::size_t kColumns = 100;

// All of a line but the sentence.
using Row = std::array<std::string, 5>;

Row heading_row() { return {"parameter", "value", "unit", "range", "symbol"}; }

Row row_of(const Config& config, const Parameter& parameter) {
  return {std::string(parameter.name), text_of(config, parameter), std::string(parameter.unit),
          range_word(parameter), std::string(parameter.symbol)};
}

// Letters, not bytes: "m²" and "θ" hold some of more than one byte.
std::size_t width_of(std::string_view text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

using Widths = std::array<std::size_t, std::tuple_size_v<Row>>;

Widths widths_of(const Config& config) {
  Widths widths{};
  const auto widen = [&widths](const Row& row) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  };
  widen(heading_row());
  for (const Parameter& parameter : parameters()) widen(row_of(config, parameter));
  return widths;
}

std::string columns_of(const Row& row, const Widths& widths) {
  std::string text;
  for (std::size_t i = 0; i < row.size(); ++i)
    text += row[i] + std::string(widths[i] - width_of(row[i]) + 2, ' ');
  return text;
}

// The words of a sentence in lines of at most `width` columns.
std::vector<std::string> wrapped(std::string_view sentence, std::size_t width) {
  std::vector<std::string> lines{""};
  while (!sentence.empty()) {
    const auto end = std::min(sentence.find(' '), sentence.size());
    const std::string_view word = sentence.substr(0, end);
    if (!lines.back().empty() && width_of(lines.back()) + 1 + width_of(word) > width)
      lines.emplace_back();
    if (!lines.back().empty()) lines.back() += ' ';
    lines.back() += word;
    sentence.remove_prefix(std::min(end + 1, sentence.size()));
  }
  return lines;
}

}  // namespace

std::string parameter_table(const Config& config, std::string_view preset) {
  const Widths widths = widths_of(config);
  const std::string heading = columns_of(heading_row(), widths);
  const std::string margin(width_of(heading), ' ');
  std::string text =
      fmt::format("GroundGrid's parameters, preset {}\n\n{}meaning\n", preset, heading);
  for (const Parameter& parameter : parameters()) {
    if (begins_stage(parameter)) text += fmt::format("\n{}\n", stage_heading(parameter));
    std::string begin = columns_of(row_of(config, parameter), widths);
    for (const std::string& line : wrapped(parameter.text, kColumns - margin.size())) {
      text += begin + line + "\n";
      begin = margin;
    }
  }
  return text;
}

}  // namespace groundgrid::program
