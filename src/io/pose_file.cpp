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
constexpr double kUnitTolerance = 1e-3;

struct Line {
  std::size_t number = 0;
  std::string_view text;
};

bool is_blank(std::string_view line) { return trimmed(line).empty(); }

bool is_comment(std::string_view line) { return trimmed(line).starts_with('#'); }

// Blank lines at the end are none, but one in the midst may stand for a pose that was lost.
std::vector<Line> lines_of(std::string_view text) {
  const std::vector<std::string_view> all = split_lines(text);
  std::vector<Line> lines;
  for (std::size_t i = 0; i < all.size(); ++i) lines.push_back({i + 1, all[i]});
  while (!lines.empty() && is_blank(lines.back().text)) lines.pop_back();
  return lines;
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

/// Collects the lines of a file in the form of TUM.
class TumParser {
 public:
  explicit TumParser(const std::filesystem::path& path) : path_(path) {}

  PoseList parse(std::span<const Line> lines) {
    for (const Line& line : lines)
      if (!is_blank(line.text)) add(line);
    return std::move(list_);
  }

 private:
  void add(const Line& line) {
    const auto numbers = parse_numbers(line.text);
    if (!numbers) fail(line, "something that is no number");
    if (numbers->size() != kNumbersOfTum) fail(line, fmt::format("{} numbers", numbers->size()));
    if (!std::all_of(numbers->begin(), numbers->end(), [](double n) { return std::isfinite(n); }))
      fail(line, "a number that is not finite");
    add(line, *numbers);
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
                 .expected = "a pose as time tx ty tz qx qy qz qw, with ever later times",
                 .got = std::move(got),
                 .remedy = "mend the line, or use --single-scan to do without poses"});
  }

  const std::filesystem::path& path_;
  PoseList list_;
};

}  // namespace

PoseList read_kitti_poses(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  return parse_kitti(path, lines_of(text));
}

PoseList read_pose_file(const std::filesystem::path& path) {
  const std::string text = read_text(path);
  std::vector<Line> lines = lines_of(text);
  std::erase_if(lines, [](const Line& line) { return is_comment(line.text); });
  const auto first = std::find_if(lines.begin(), lines.end(),
                                  [](const Line& line) { return !is_blank(line.text); });
  if (first == lines.end())
    throw Error({.file = path,
                 .expected = "poses, one a line",
                 .got = "none",
                 .remedy = "use --single-scan to do without poses"});
  switch (split_words(first->text).size()) {
    case kNumbersOfTum:
      return TumParser(path).parse(lines);
    case 12:
      return parse_kitti(path, lines);
    default:
      throw Error({.file = path,
                   .line = first->number,
                   .expected = "the twelve numbers of a KITTI pose, or time tx ty tz qx qy qz qw",
                   .got = fmt::format("{} words", split_words(first->text).size()),
                   .remedy = "convert the poses, or use --single-scan to do without"});
  }
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
