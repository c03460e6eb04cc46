#include "io/ply_header.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include "io/error.hpp"
#include "io/number_list.hpp"

namespace groundgrid::io {
namespace {

struct NamedType {
  std::string_view name;
  FieldType type;
};
constexpr std::array<NamedType, 16> kTypes{{{"char", FieldType::int8},
                                            {"int8", FieldType::int8},
                                            {"uchar", FieldType::uint8},
                                            {"uint8", FieldType::uint8},
                                            {"short", FieldType::int16},
                                            {"int16", FieldType::int16},
                                            {"ushort", FieldType::uint16},
                                            {"uint16", FieldType::uint16},
                                            {"int", FieldType::int32},
                                            {"int32", FieldType::int32},
                                            {"uint", FieldType::uint32},
                                            {"uint32", FieldType::uint32},
                                            {"float", FieldType::float32},
                                            {"float32", FieldType::float32},
                                            {"double", FieldType::float64},
                                            {"float64", FieldType::float64}}};

/// Turns the lines of a header into its parts.
class HeaderParser {
 public:
  explicit HeaderParser(InputFile& file) : file_(file) {}

  PlyHeader parse() {
    if (next_line() != "ply")
      fail("the word 'ply' alone in the first line", in_quotes(line_),
           "if the file has another format, say which with --format");
    while (take(split_words(next_line()))) {
    }
    if (!has_format_) fail("a line 'format' in the header", "none");
    return std::move(header_);
  }

 private:
  const std::string& next_line() {
    ++number_;
    std::optional<std::string> line = file_.read_line();
    if (!line) fail("a PLY header that ends with the line end_header", "the end of the file");
    line_ = std::move(*line);
    return line_;
  }

  // Takes one line; false at the last one.
  bool take(const std::vector<std::string_view>& words) {
    if (words.empty() || words[0] == "comment" || words[0] == "obj_info") return true;
    if (words[0] == "end_header") return false;
    if (words[0] == "format")
      take_format(words);
    else if (words[0] == "element")
      take_element(words);
    else if (words[0] == "property")
      take_property(words);
    else
      fail("a line of a PLY header (format, element, property, comment, obj_info, end_header)",
           in_quotes(words[0]));
    return true;
  }

  void take_format(const std::vector<std::string_view>& words) {
    constexpr std::array<std::pair<std::string_view, CloudEncoding>, 3> kFormats{
        {{"ascii", CloudEncoding::ascii},
         {"binary_little_endian", CloudEncoding::binary},
         {"binary_big_endian", CloudEncoding::binary_big_endian}}};
    if (has_format_) fail("one line 'format'", "a second one");
    has_format_ = true;
    for (const auto& [name, encoding] : kFormats)
      if (words.size() == 3 && words[1] == name && words[2] == "1.0") {
        header_.encoding = encoding;
        return;
      }
    fail("format ascii, binary_little_endian or binary_big_endian 1.0", in_quotes(line_));
  }

  void take_element(const std::vector<std::string_view>& words) {
    const auto count = words.size() == 3 ? parse_whole_number(words[2]) : std::nullopt;
    if (!count) fail("'element', a name and a whole number", in_quotes(line_));
    header_.elements.push_back({std::string(words[1]), *count});
  }

  void take_property(const std::vector<std::string_view>& words) {
    if (header_.elements.empty()) fail("an element before its properties", in_quotes(line_));
    PlyProperty property{.name = std::string(words.back())};
    if (words.size() == 3) {
      property.type = type_named(words[1]);
    } else if (words.size() == 5 && words[1] == "list") {
      property.count_type = type_named(words[2]);
      property.type = type_named(words[3]);
    } else {
      fail("'property', a type and a name, or 'property list', two types and a name",
           in_quotes(line_));
    }
    header_.elements.back().properties.push_back(std::move(property));
  }

  FieldType type_named(std::string_view name) const {
    for (const NamedType& known : kTypes)
      if (known.name == name) return known.type;
    fail("a type of PLY (char, uchar, short, ushort, int, uint, float, double, or int8 to float64)",
         in_quotes(name));
  }

  [[noreturn]] void fail(std::string expected, std::string got,
                         std::string remedy = "mend the header") const {
    throw Error({.file = file_.path(),
                 .line = number_,
                 .expected = std::move(expected),
                 .got = std::move(got),
                 .remedy = std::move(remedy)});
  }

  InputFile& file_;
  std::string line_;
  std::size_t number_ = 0;  ///< Of that line.
  bool has_format_ = false;
  PlyHeader header_;
};

}  // namespace

bool PlyElement::has_lists() const {
  return std::any_of(properties.begin(), properties.end(),
                     [](const PlyProperty& property) { return property.count_type.has_value(); });
}

std::size_t PlyElement::bytes() const {
  std::size_t bytes = 0;
  for (const PlyProperty& property : properties)
    if (!property.count_type) bytes += size_of(property.type);
  return bytes;
}

PlyHeader read_ply_header(InputFile& file) { return HeaderParser(file).parse(); }

}  // namespace groundgrid::io
