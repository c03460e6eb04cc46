#include "io/pcd_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "io/error.hpp"
#include "io/number_list.hpp"

namespace groundgrid::io {
namespace {

constexpr std::array<std::string_view, 10> kKeywords{
    "VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"};
constexpr std::array<std::string_view, 6> kVersions{"0.7", ".7", "0.6", ".6", "0.5", ".5"};

struct HeaderLine {
  std::size_t number = 0;
  std::vector<std::string> words;  ///< Without the keyword.
};

/// The lines of a header by their keywords, up to the one that ends it, DATA.
class HeaderLines {
 public:
  explicit HeaderLines(InputFile& file) : path_(file.path()) {
    while (find("DATA") == nullptr) {
      const std::optional<std::string> text = file.read_line();
      if (!text)
        throw Error({.file = path_,
                     .line = file.lines() + 1,
                     .expected = "a PCD header that ends with the line DATA",
                     .got = "the end of the file",
                     .remedy = "the file is cut short or has another format; say which with "
                               "--format"});
      add(*text, file.lines());
    }
  }

  /// The line of that keyword, or null.
  [[nodiscard]] const HeaderLine* find(std::string_view keyword) const {
    const auto line = lines_.find(keyword);
    return line == lines_.end() ? nullptr : &line->second;
  }

  [[nodiscard]] const HeaderLine& require(std::string_view keyword) const {
    if (const HeaderLine* const line = find(keyword)) return *line;
    throw Error({.file = path_,
                 .expected = fmt::format("a line {} in the header", keyword),
                 .got = "none"});
  }

  /// The words of a line that must have one for each of so many fields.
  [[nodiscard]] const std::vector<std::string>& words(std::string_view keyword,
                                                      std::size_t fields) const {
    const HeaderLine& line = require(keyword);
    if (line.words.size() != fields)
      fail(line, fmt::format("{} words after {}, one for each of FIELDS", fields, keyword),
           fmt::format("{}", line.words.size()));
    return line.words;
  }

  /// The only word of a line.
  [[nodiscard]] const std::string& word(std::string_view keyword) const {
    const HeaderLine& line = require(keyword);
    if (line.words.size() != 1)
      fail(line, fmt::format("one word after {}", keyword), fmt::format("{}", line.words.size()));
    return line.words.front();
  }

  /// The whole number that is a line's only word; nothing where there is no such line.
  [[nodiscard]] std::optional<std::size_t> number(std::string_view keyword) const {
    const HeaderLine* const line = find(keyword);
    if (line == nullptr) return std::nullopt;
    const auto value = parse_whole_number(word(keyword));
    if (!value)
      fail(*line, fmt::format("a whole number after {}", keyword), in_quotes(word(keyword)));
    return value;
  }

  [[noreturn]] void fail(const HeaderLine& line, std::string expected, std::string got,
                         std::string remedy = "mend the header") const {
    throw Error({.file = path_,
                 .line = line.number,
                 .expected = std::move(expected),
                 .got = std::move(got),
                 .remedy = std::move(remedy)});
  }

 private:
  void add(std::string_view text, std::size_t number) {
    const std::vector<std::string_view> words = split_words(text);
    if (words.empty() || words.front().front() == '#') return;
    const std::string_view keyword = words.front();
    HeaderLine line{number, {words.begin() + 1, words.end()}};
    if (std::find(kKeywords.begin(), kKeywords.end(), keyword) == kKeywords.end())
      fail(line, fmt::format("a line of a PCD header ({})", fmt::join(kKeywords, ", ")),
           in_quotes(keyword), "if the file has another format, say which with --format");
    if (find(keyword) != nullptr) fail(line, fmt::format("one line {}", keyword), "a second one");
    lines_.emplace(keyword, std::move(line));
  }

  std::filesystem::path path_;
  std::map<std::string, HeaderLine, std::less<>> lines_;
};

std::optional<FieldType> field_type(std::string_view type, std::string_view size) {
  struct Known {
    std::string_view type, size;
    FieldType field;
  };
  constexpr std::array<Known, 10> kKnown{{{"I", "1", FieldType::int8},
                                          {"U", "1", FieldType::uint8},
                                          {"I", "2", FieldType::int16},
                                          {"U", "2", FieldType::uint16},
                                          {"I", "4", FieldType::int32},
                                          {"U", "4", FieldType::uint32},
                                          {"I", "8", FieldType::int64},
                                          {"U", "8", FieldType::uint64},
                                          {"F", "4", FieldType::float32},
                                          {"F", "8", FieldType::float64}}};
  for (const Known& known : kKnown)
    if (known.type == type && known.size == size) return known.field;
  return std::nullopt;
}

// So many numbers that no record of any header overflows a 64-bit size.
std::optional<std::size_t> field_count(std::string_view text) {
  const auto count = parse_whole_number(text);
  const bool valid = count && *count >= 1 && *count <= std::numeric_limits<std::uint32_t>::max();
  return valid ? count : std::nullopt;
}

void read_fields(const HeaderLines& lines, PointCloud& cloud) {
  const std::vector<std::string>& names = lines.require("FIELDS").words;
  const std::vector<std::string>& sizes = lines.words("SIZE", names.size());
  const std::vector<std::string>& types = lines.words("TYPE", names.size());
  const std::vector<std::string> counts = lines.find("COUNT") != nullptr
                                              ? lines.words("COUNT", names.size())
                                              : std::vector<std::string>(names.size(), "1");
  for (std::size_t i = 0; i < names.size(); ++i) {
    const auto type = field_type(types[i], sizes[i]);
    if (!type)
      lines.fail(lines.require("TYPE"), "I or U of SIZE 1, 2, 4 or 8, or F of SIZE 4 or 8",
                 fmt::format("TYPE {} of SIZE {} for {}", in_quotes(types[i]), in_quotes(sizes[i]),
                             in_quotes(names[i])));
    const auto count = field_count(counts[i]);
    if (!count)
      lines.fail(lines.require("COUNT"), "a COUNT from 1 to 4294967295",
                 fmt::format("{} for {}", in_quotes(counts[i]), in_quotes(names[i])));
    cloud.add_field(names[i], *type, *count);
  }
}

// Rows of an organised cloud, where the header does not say how many there are.
std::size_t rows(std::optional<std::size_t> points, std::optional<std::size_t> width) {
  const bool whole = points && width && *width > 0 && *points % *width == 0;
  return whole && *points > 0 ? *points / *width : 1;
}

void read_shape(const HeaderLines& lines, PointCloud& cloud) {
  const auto points = lines.number("POINTS");
  const auto width = lines.number("WIDTH");
  const auto height = lines.number("HEIGHT");
  if (!points && !width) (void)lines.require("WIDTH");
  cloud.height = height ? *height : rows(points, width);
  if (width)
    cloud.width = *width;
  else
    cloud.width = cloud.height == 0 ? 0 : *points / cloud.height;
  const HeaderLine& place = *(lines.find(points ? "POINTS" : "WIDTH"));
  if (cloud.height > 0 && cloud.width > std::numeric_limits<std::size_t>::max() / cloud.height)
    lines.fail(place, "fewer than 2^64 points",
               fmt::format("WIDTH {} and HEIGHT {}", cloud.width, cloud.height));
  if (points && *points != cloud.size())
    lines.fail(place, "as many POINTS as WIDTH times HEIGHT",
               fmt::format("{} instead of {} times {}", *points, cloud.width, cloud.height));
}

void read_encoding(const HeaderLines& lines, PointCloud& cloud) {
  const std::string& word = lines.word("DATA");
  if (word == "ascii")
    cloud.encoding = CloudEncoding::ascii;
  else if (word == "binary")
    cloud.encoding = CloudEncoding::binary;
  else if (word == "binary_compressed")
    cloud.encoding = CloudEncoding::binary_compressed;
  else
    lines.fail(lines.require("DATA"), "DATA ascii, binary or binary_compressed", in_quotes(word));
}

void read_viewpoint(const HeaderLines& lines, PointCloud& cloud) {
  const HeaderLine* const line = lines.find("VIEWPOINT");
  if (line == nullptr) return;
  cloud.viewpoint = fmt::format("{}", fmt::join(line->words, " "));
  const auto numbers = parse_numbers(cloud.viewpoint);
  if (!numbers || numbers->size() != 7)
    lines.fail(*line, "seven numbers after VIEWPOINT (tx ty tz qw qx qy qz)",
               in_quotes(cloud.viewpoint));
}

}  // namespace

void read_pcd_header(InputFile& file, PointCloud& cloud) {
  const HeaderLines lines(file);
  if (lines.find("VERSION") != nullptr &&
      std::find(kVersions.begin(), kVersions.end(), lines.word("VERSION")) == kVersions.end())
    lines.fail(lines.require("VERSION"), "VERSION 0.7 or one before it",
               in_quotes(lines.word("VERSION")), "convert the file to version 0.7");
  read_fields(lines, cloud);
  read_shape(lines, cloud);
  read_viewpoint(lines, cloud);
  read_encoding(lines, cloud);
}

}  // namespace groundgrid::io
