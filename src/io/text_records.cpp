#include "io/text_records.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <system_error>
#include <type_traits>

#include "io/error.hpp"
#include "io/field_number.hpp"
#include "io/number_list.hpp"
#include "io/text.hpp"

namespace groundgrid::io {
namespace {

template <typename Number>
bool parse_whole(std::string_view word, Number& number) {
  word = without_plus(word);
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  return error == std::errc{} && stop == end;
}

bool parse(std::string_view word, double& number) {
  const auto value = parse_number(word);
  if (value) number = *value;
  return value.has_value();
}

// What is beyond the range of a float becomes infinite or zero, as it does in a computation.
bool parse(std::string_view word, float& number) {
  if (parse_whole(word, number)) return true;
  double wide = 0.0;
  if (!parse(word, wide)) return false;
  number = static_cast<float>(wide);
  return true;
}

// Programs that know floats only write whole numbers as 3.0 or 3e0.
template <typename Integer>
bool parse(std::string_view word, Integer& number) {
  if (parse_whole(word, number)) return true;
  using Limits = std::numeric_limits<Integer>;
  double wide = 0.0;
  if (!parse(word, wide) || wide != std::trunc(wide) || wide < static_cast<double>(Limits::min()) ||
      wide >= static_cast<double>(Limits::max()) + 1.0)
    return false;
  number = static_cast<Integer>(wide);
  return true;
}

template <typename Number>
bool parse_to(std::string_view word, std::byte* place) {
  Number number{};
  if (!parse(word, number)) return false;
  std::memcpy(place, &number, sizeof number);
  return true;
}

bool parse_to(FieldType type, std::string_view word, std::byte* place) {
  return with_number(type, [&](auto zero) { return parse_to<decltype(zero)>(word, place); });
}

template <typename Number>
void append(std::string& text, const std::byte* place) {
  constexpr std::size_t kLongestNumber = 32;
  Number number;
  std::memcpy(&number, place, sizeof number);
  std::array<char, kLongestNumber> digits{};
  const auto result = std::to_chars(digits.data(), digits.data() + digits.size(), number);
  text.append(digits.data(), result.ptr);
}

std::size_t numbers_per_record(const PointCloud& cloud) {
  std::size_t numbers = 0;
  for (const PointField& field : cloud.fields) numbers += field.count;
  return std::max<std::size_t>(numbers, 1);
}

}  // namespace

TextRecords::TextRecords(InputFile& file, std::size_t most_bytes)
    : file_(file), line_(file.lines()) {
  file.read_into(text_,
                 static_cast<std::size_t>(std::min<std::uintmax_t>(file.remaining(), most_bytes)));
  rest_ = text_;
}

std::string_view TextRecords::peek() {
  while (!rest_.empty()) {
    const std::string_view line = rest_.substr(0, rest_.find('\n'));
    if (!trimmed(line).empty()) return line;
    rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
    ++line_;
  }
  return {};
}

std::string_view TextRecords::next_line() {
  const std::string_view line = peek();
  if (line.empty()) return line;
  rest_.remove_prefix(std::min(line.size() + 1, rest_.size()));
  ++line_;
  return line;
}

std::size_t TextRecords::count() const {
  std::size_t lines = 0;
  for (std::string_view rest = rest_; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    if (!trimmed(line).empty()) ++lines;
    rest.remove_prefix(std::min(line.size() + 1, rest.size()));
  }
  return lines;
}

void TextRecords::make_blank(std::string_view letters) {
  const auto begin = text_.end() - static_cast<std::ptrdiff_t>(rest_.size());
  std::replace_if(
      begin, text_.end(),
      [&](char letter) { return letters.find(letter) != std::string_view::npos; }, ' ');
}

void TextRecords::skip(std::size_t records) {
  for (std::size_t i = 0; i < records; ++i)
    if (next_line().empty())
      throw Error({.file = file_.path(),
                   .line = line_,
                   .expected = fmt::format("{} lines of an element before the points", records),
                   .got = fmt::format("the end of the file after {}", i),
                   .remedy = "the file is cut short; fetch it again"});
}

void TextRecords::read(PointCloud& cloud, std::span<const std::size_t> lists) {
  // A number takes two letters at least, with the blank or line end after it.
  const std::size_t most = (rest_.size() + 1) / 2 / numbers_per_record(cloud);
  if (cloud.size() > most)
    throw Error({.file = file_.path(),
                 .line = line_ + 1,
                 .expected = fmt::format("{} points, as the header promises", cloud.size()),
                 .got = fmt::format("{} bytes of text, which hold {} at most", rest_.size(), most),
                 .remedy = "the file is cut short; fetch it again"});
  file_.resize(cloud.data, cloud.size() * cloud.stride_bytes);
  for (std::size_t point = 0; point < cloud.size(); ++point) {
    const std::string_view line = next_line();
    if (line.empty())
      throw Error({.file = file_.path(),
                   .line = line_,
                   .expected = fmt::format("{} points, as the header promises", cloud.size()),
                   .got = fmt::format("the end of the file after {}", point),
                   .remedy = "the file is cut short; fetch it again"});
    read_record(line, cloud, lists, cloud.data.data() + point * cloud.stride_bytes);
  }
}

void TextRecords::skip_list(std::string_view& line) const {
  const auto fail = [&](std::string_view word) {
    throw Error({.file = file_.path(),
                 .line = line_,
                 .expected = "the count of a list and so many numbers",
                 .got = word.empty() ? "the end of the line" : in_quotes(word)});
  };
  const std::string_view word = take_word(line);
  double count = 0.0;
  // No list has more numbers than its line has letters; NaN is no count either.
  if (!parse(word, count) || !(count >= 0.0 && count <= static_cast<double>(line.size())))
    fail(word);
  for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
    if (take_word(line).empty()) fail("");
}

void TextRecords::read_record(std::string_view line, const PointCloud& cloud,
                              std::span<const std::size_t> lists, std::byte* record) const {
  const auto skip_lists_before = [&](std::size_t index) {
    for (; !lists.empty() && lists.front() == index; lists = lists.subspan(1)) skip_list(line);
  };
  for (const PointField& field : cloud.fields) {
    skip_lists_before(static_cast<std::size_t>(&field - cloud.fields.data()));
    for (std::size_t i = 0; i < field.count; ++i) {
      const std::string_view word = take_word(line);
      if (parse_to(field.type, word, record + field.offset + i * size_of(field.type))) continue;
      throw Error(
          {.file = file_.path(),
           .line = line_,
           .expected = fmt::format("a {} for {}", name_of(field.type), in_quotes(field.name)),
           .got = word.empty() ? "the end of the line" : in_quotes(word)});
    }
  }
  skip_lists_before(cloud.fields.size());
  const std::string_view surplus = take_word(line);
  if (!surplus.empty())
    throw Error({.file = file_.path(),
                 .line = line_,
                 .expected = fmt::format("{} numbers", numbers_per_record(cloud)),
                 .got = fmt::format("more: {}", in_quotes(surplus))});
}

void TextRecords::require_end() {
  const std::string_view line = next_line();
  if (!line.empty())
    throw Error({.file = file_.path(),
                 .line = line_,
                 .expected = "the end of the file after as many points as the header says",
                 .got = in_quotes(line),
                 .remedy = "mend the number of points in the header"});
}

std::string text_of_records(const PointCloud& cloud) {
  std::string text;
  for (std::size_t point = 0; point < cloud.size(); ++point) {
    const std::byte* const record = cloud.data.data() + point * cloud.stride_bytes;
    for (const PointField& field : cloud.fields)
      for (std::size_t i = 0; i < field.count; ++i) {
        const std::byte* const place = record + field.offset + i * size_of(field.type);
        with_number(field.type, [&](auto zero) { append<decltype(zero)>(text, place); });
        text += ' ';
      }
    text.back() = '\n';
  }
  return text;
}

}  // namespace groundgrid::io
