#include "io/number_list.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <clocale>
#include <cstdlib>
#include <stdexcept>
#include <string>
#include <system_error>

#include "io/text.hpp"

namespace groundgrid::io {
namespace {

constexpr double kRigidTolerance = 1e-3;

// std::from_chars does not say on which side a number is out of range. In the locale C, so that
// the decimal point is one in every country.
double number_out_of_range(std::string_view word) {
  static const locale_t c_locale = ::newlocale(LC_ALL_MASK, "C", locale_t{});
  return ::strtod_l(std::string(word).c_str(), nullptr, c_locale);
}

}  // namespace

std::string_view without_plus(std::string_view number) {
  if (number.size() > 1 && number[0] == '+' && number[1] != '-') number.remove_prefix(1);
  return number;
}

std::optional<double> parse_number(std::string_view word) {
  word = without_plus(word);
  double number = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, number);
  if (stop != end || error == std::errc::invalid_argument) return std::nullopt;
  return error == std::errc::result_out_of_range ? number_out_of_range(word) : number;
}

std::optional<std::vector<double>> parse_numbers(std::string_view line) {
  std::vector<double> numbers;
  for (const std::string_view word : split_words(line)) {
    const auto number = parse_number(word);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

std::optional<std::size_t> parse_whole_number(std::string_view text) {
  std::size_t number = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return number;
}

std::vector<std::string_view> split_words(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::string_view word = take_word(line); !word.empty(); word = take_word(line))
    words.push_back(word);
  return words;
}

std::vector<std::string_view> split_columns(std::string_view line) {
  const char separator = line.find(';') != std::string_view::npos ? ';' : ',';
  if (line.find(separator) == std::string_view::npos) return split_words(line);
  std::vector<std::string_view> columns;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(separator, begin), line.size());
    columns.push_back(trimmed(line.substr(begin, end - begin)));
    begin = end + 1;
  }
  return columns;
}

std::optional<Eigen::Isometry3d> rigid_transform(std::span<const double> rows) {
  using Rows = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;
  constexpr std::array kLastRow{0.0, 0.0, 0.0, 1.0};
  if (rows.size() != 12 &&
      !(rows.size() == 16 && std::equal(kLastRow.begin(), kLastRow.end(), rows.begin() + 12)))
    return std::nullopt;
  const Rows matrix = Eigen::Map<const Rows>(rows.data());
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  const Eigen::Matrix3d error = rotation * rotation.transpose() - Eigen::Matrix3d::Identity();
  if (!matrix.allFinite() || error.cwiseAbs().maxCoeff() > kRigidTolerance ||
      rotation.determinant() < 0.0)
    return std::nullopt;
  Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
  transform.linear() = Eigen::Quaterniond(rotation).normalized().toRotationMatrix();
  transform.translation() = matrix.col(3);
  return transform;
}

Eigen::Isometry3d parse_rigid_transform(std::string_view line) {
  const auto numbers = parse_numbers(line);
  if (!numbers) throw std::invalid_argument("something that is no number");
  if (numbers->size() != 12 && numbers->size() != 16)
    throw std::invalid_argument(fmt::format("{} numbers", numbers->size()));
  const auto transform = rigid_transform(*numbers);
  if (!transform) throw std::invalid_argument("numbers that are no rotation and translation");
  return *transform;
}

std::vector<std::string_view> split_lines(std::string_view text) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.remove_prefix(kByteOrderMark.size());
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const auto end = text.find('\n');
    std::string_view line = text.substr(0, end);
    if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
    lines.push_back(line);
    text.remove_prefix(end == std::string_view::npos ? text.size() : end + 1);
  }
  return lines;
}

}  // namespace groundgrid::io
