#include "io/text_cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/coordinate_fields.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "io/text.hpp"
#include "io/text_records.hpp"

namespace groundgrid::io {
namespace {

constexpr std::size_t kBytesToTell = 65536;
constexpr std::string_view kSeparators = ",;";

using Names = std::vector<std::string>;

TextRecords text_of(InputFile& file,
                    std::size_t most_bytes = std::numeric_limits<std::size_t>::max()) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (file.peek(kByteOrderMark.size()) == kByteOrderMark) file.skip(kByteOrderMark.size());
  return TextRecords(file, most_bytes);
}

std::string_view without_mark(std::string_view line) {
  line = trimmed(line);
  for (const std::string_view mark : {"#", "//"})
    if (line.starts_with(mark)) return trimmed(line.substr(mark.size()));
  return line;
}

bool is_marked(std::string_view line) { return without_mark(line) != trimmed(line); }

// VeloView and ParaView write the coordinates so.
std::string name_of_column(std::string_view column) {
  if (column.size() > 1 && column.front() == '"' && column.back() == '"')
    column = column.substr(1, column.size() - 2);
  if (column.starts_with("Points"))
    for (const auto& [ending, name] : {std::pair{":0", "x"}, {":1", "y"}, {":2", "z"}})
      if (column.ends_with(ending)) return name;
  return std::string(column);
}

bool is_of_numbers(std::string_view line) {
  const std::vector<std::string_view> columns = split_columns(line);
  return !columns.empty() &&
         std::all_of(columns.begin(), columns.end(),
                     [](std::string_view column) { return parse_number(column).has_value(); });
}

// The names in a line that has one for each coordinate; nothing in prose.
std::optional<Names> names_in(std::string_view line) {
  Names names;
  for (const std::string_view column : split_columns(without_mark(line)))
    names.push_back(name_of_column(column));
  for (const auto& [lower, upper] : {std::pair{"x", "X"}, {"y", "Y"}, {"z", "Z"}})
    if (std::find(names.begin(), names.end(), lower) == names.end() &&
        std::find(names.begin(), names.end(), upper) == names.end())
      return std::nullopt;
  return names;
}

std::optional<Names> usual_names(std::size_t columns) {
  switch (columns) {
    case 3:
      return Names{"x", "y", "z"};
    case 4:
      return Names{"x", "y", "z", "intensity"};
    case 6:
      return Names{"x", "y", "z", "r", "g", "b"};
    case 7:
      return Names{"x", "y", "z", "intensity", "r", "g", "b"};
    default:
      return std::nullopt;
  }
}

// What stands in front of the points.
struct Preamble {
  std::optional<Names> names{};
  std::optional<std::size_t> points{};
};

Preamble take_preamble(TextRecords& text) {
  Preamble preamble;
  for (std::string_view line = text.peek(); !line.empty(); line = text.peek()) {
    const auto count = parse_whole_number(trimmed(line));
    const auto names = is_of_numbers(line) ? std::nullopt : names_in(line);
    if (count && !preamble.points)
      preamble.points = count;
    else if (names && !preamble.names)
      preamble.names = names;
    else if (!is_marked(line))
      break;
    text.skip(1);
  }
  return preamble;
}

[[noreturn]] void fail_at(const InputFile& file, const TextRecords& text, std::string expected,
                          std::string got, std::string remedy) {
  throw Error({.file = file.path(),
               .line = text.line() + 1,
               .expected = std::move(expected),
               .got = std::move(got),
               .remedy = std::move(remedy)});
}

Names names_of_columns(const InputFile& file, TextRecords& text, const Preamble& preamble) {
  const std::string_view line = text.peek();
  if (line.find(';') != std::string_view::npos && line.find(',') != std::string_view::npos)
    fail_at(file, text, "numbers with decimal points", "decimal commas", "write them with points");
  if (preamble.names) return *preamble.names;
  const std::size_t columns = split_columns(line).size();
  // The names of no columns at all are those of an empty cloud.
  const auto names = usual_names(line.empty() ? 3 : columns);
  if (!line.empty() && !is_of_numbers(line))
    fail_at(file, text, "the numbers of a point, or names of columns with x, y and z among them",
            in_quotes(line), "name the columns in the first line, separated as the numbers are");
  if (!names)
    fail_at(file, text, "x y z, x y z intensity, x y z r g b or x y z intensity r g b",
            fmt::format("{} columns without names", columns),
            "name the columns in a line before the points (x y z ...)");
  return *names;
}

}  // namespace

void read_text_cloud(const std::filesystem::path& path, PointCloud& cloud) {
  InputFile file(path);
  TextRecords text = text_of(file);
  const Preamble preamble = take_preamble(text);
  for (const std::string& name : names_of_columns(file, text, preamble))
    cloud.add_field(name, FieldType::float64);
  name_coordinates(path, cloud);
  cloud.encoding = CloudEncoding::ascii;
  cloud.width = preamble.points.value_or(text.count());
  text.make_blank(kSeparators);
  text.read(cloud);
  text.require_end();
}

bool is_text_cloud(const std::filesystem::path& path) {
  try {
    InputFile file(path);
    TextRecords text = text_of(file, kBytesToTell);
    const Preamble preamble = take_preamble(text);
    const std::string_view line = text.peek();
    return preamble.names || (is_of_numbers(line) && usual_names(split_columns(line).size()));
  } catch (const Error&) {
    return false;
  }
}

}  // namespace groundgrid::io
