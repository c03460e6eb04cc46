#include "io/pose_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"
#include "io/text.hpp"

namespace groundgrid::io {
namespace {

constexpr std::size_t kNumbersOfTum = 8;
constexpr std::size_t kNumbersOfEuroc = 17;
constexpr double kUnitTolerance = 1e-3;

struct Line {
  std::size_t number = 0;
  std::string_view text;
};

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

// Blank lines at the end are none, but one in the midst may stand for a pose that was lost.
std::vector<Line> lines_of(std::string_view text) {
  const std::vector<std::string_view> all = split_lines(text);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < all.size(); ++i) lines.push_back({i + 1, all[i]});
  while (!lines.empty() && is_blank(lines.back().text)) lines.pop_back();
  return lines;
}

bool is_comment(const Line& line) { return trimmed(line.text).starts_with('#'); }

// Takes the comments out, and names of columns that stand before the first pose without a '#'.
// Returns the last line of these before it: prose is no matter, since only one column is looked at.
std::string_view take_header(std::vector<Line>& lines) {
  std::string_view header;
  auto line = lines.begin();
  for (; line != lines.end() && (is_comment(*line) || is_blank(line->text)); ++line)
    if (is_comment(*line)) header = line->text;
  if (line != lines.end()) {
    const std::vector<std::string_view> columns = split_columns(line->text);
    const bool has_number = std::any_of(columns.begin(), columns.end(), [](std::string_view name) {
      return parse_number(name).has_value();
    });
    if (columns.size() >= kNumbersOfTum && !has_number) {
      header = line->text;
      lines.erase(line);
    }
  }
  std::erase_if(lines, is_comment);
  return header;
}

PoseList parse_kitti(const std::filesystem::path& path, std::span<const Line> lines) {
  PoseList list;
  list.poses.reserve(lines.size());
  for (const Line& line : lines) {
    try {
      list.poses.push_back(parse_rigid_transform(line.text));
    } catch (const std::invalid_argument& problem) {
      throw Error({.file = path,
                   .line = line.number,
                   .expected = "the twelve numbers of a rigid transform",
                   .got = problem.what(),
                   .remedy = "mend the line, or use --single-scan to do without poses"});
    }
  }
  return list;
}

// Takes the number of the scan off the beginning of every line; the rest is in KITTI's form.
std::vector<std::size_t> take_numbers(const std::filesystem::path& path, std::vector<Line>& lines) {
  std::vector<std::size_t> numbers;
  for (Line& line : lines) {
    const std::string_view word = take_word(line.text);
    const auto number = parse_whole_number(word);
    if (!number || (!numbers.empty() && *number <= numbers.back()))
      throw Error({.file = path,
                   .line = line.number,
                   .expected = "the number of a scan, greater than the one before, and its pose",
                   .got = in_quotes(word),
                   .remedy = "mend the line, or use --single-scan to do without poses"});
    numbers.push_back(*number);
  }
  return numbers;
}

/// Collects the lines of a file with a time and a quaternion in each.
class TimedParser {
 public:
  // The file's own header, if any, says whether the real part of the quaternion is first.
  TimedParser(const std::filesystem::path& path, bool is_asl, std::string_view header)
      : path_(path), is_asl_(is_asl) {
    const std::vector<std::string_view> names = split_columns(header);
    const bool w_is_last =
        names.size() >= kNumbersOfTum && words_end_in_w(names[kNumbersOfTum - 1]);
    w_is_first_ = is_asl && !w_is_last;
  }

  PoseList parse(std::span<const Line> lines) {
    for (const Line& line : lines)
      if (!is_blank(line.text)) add(line);
    return std::move(list_);
  }

 private:
  // "qw", or "q_RS_w []" with its unit.
  static bool words_end_in_w(std::string_view name) { return take_word(name).ends_with('w'); }

  void add(const Line& line) {
    std::vector<std::string_view> columns = split_columns(line.text);
    if (is_asl_ && columns.size() > kNumbersOfTum) columns.resize(kNumbersOfTum);
    std::vector<double> numbers;
    for (const std::string_view column : columns) {
      const auto number = parse_number(column);
      if (!number) fail(line, "something that is no number");
      if (!std::isfinite(*number)) fail(line, "a number that is not finite");
      numbers.push_back(*number);
    }
    if (numbers.size() != kNumbersOfTum) fail(line, fmt::format("{} numbers", numbers.size()));
    if (is_asl_ && parse_whole_number(columns[0])) numbers[0] *= 1e-9;
    if (w_is_first_) std::rotate(numbers.begin() + 4, numbers.begin() + 5, numbers.end());
    add(line, numbers);
  }

  void add(const Line& line, std::span<const double> n) {
    const Eigen::Quaterniond rotation(n[7], n[4], n[5], n[6]);
    if (std::abs(rotation.norm() - 1.0) > kUnitTolerance)
      fail(line, fmt::format("a quaternion of length {:.6g} instead of 1", rotation.norm()));
    if (!list_.times.empty() && n[0] <= list_.times.back())
      fail(line, fmt::format("the time {} s after {} s", n[0], list_.times.back()));
    list_.times.push_back(n[0]);
    list_.poses.push_back(Eigen::Translation3d(n[1], n[2], n[3]) * rotation.normalized());
  }

  [[noreturn]] void fail(const Line& line, std::string got) const {
    throw Error({.file = path_,
                 .line = line.number,
                 .expected = fmt::format("a pose as time tx ty tz {}, with ever later times",
                                         w_is_first_ ? "qw qx qy qz" : "qx qy qz qw"),
                 .got = std::move(got),
                 .remedy = "mend the line, or use --single-scan to do without poses"});
  }

  const std::filesystem::path& path_;
  bool is_asl_;
  bool w_is_first_ = false;
  PoseList list_;
};

PoseList parse_poses(const std::filesystem::path& path, std::vector<Line> lines,
                     std::string_view header) {
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [](const Line& line) { return !is_blank(line.text); });
  if (first == lines.end())
    throw Error({.file = path,
                 .expected = "poses, one a line",
                 .got = "none",
                 .remedy = "use --single-scan to do without poses"});
  const std::size_t columns = split_columns(first->text).size();
  const bool commas = first->text.find(',') != std::string_view::npos;
  if (columns == kNumbersOfTum || (commas && columns == kNumbersOfEuroc))
    return TimedParser(path, commas, header).parse(lines);
  if (!commas && (columns == 12 || columns == 16)) return parse_kitti(path, lines);
  if (!commas && (columns == 13 || columns == 17)) {
    std::erase_if(lines, [](const Line& line) { return is_blank(line.text); });
    std::vector<std::size_t> numbers = take_numbers(path, lines);
    PoseList list = parse_kitti(path, lines);
    list.numbers = std::move(numbers);
    return list;
  }
  throw Error({.file = path,
               .line = first->number,
               .expected = "the twelve numbers of a KITTI pose, or time tx ty tz qx qy qz qw",
               .got = fmt::format("{} {}", columns, commas ? "columns" : "words"),
               .remedy = "convert the poses, or use --single-scan to do without"});
}

}  // namespace

PoseList read_kitti_poses(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  return parse_kitti(path, lines_of(text));
}

PoseList read_pose_file(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  std::vector<Line> lines = lines_of(text);
  const std::string_view header = take_header(lines);
  return parse_poses(path, std::move(lines), header);
}

std::vector<double> read_scan_times(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  std::vector<double> times;
  for (const Line& line : lines_of(text)) {
    const auto numbers = parse_numbers(line.text);
    if (!numbers || numbers->size() != 1 || !std::isfinite(numbers->front()))
      throw Error({.file = path,
                   .line = line.number,
                   .expected = "the time of a scan in seconds",
                   .got = in_quotes(line.text)});
    times.push_back(numbers->front());
  }
  return times;
}

}  // namespace groundgrid::io
