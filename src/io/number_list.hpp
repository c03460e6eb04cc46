#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace groundgrid::io {

/// A number as std::from_chars takes it: without the '+' that may stand before it.
std::string_view without_plus(std::string_view number);

/// A text that is a number, maybe with a '+' before it, nan or inf, and nothing else. What a double
/// does not hold becomes infinite or zero, as it does in a computation.
std::optional<double> parse_number(std::string_view word);

/// The numbers in a line of text, separated by blanks and read the same in every locale; nothing
/// where a word is no number.
std::optional<std::vector<double>> parse_numbers(std::string_view line);

/// A text that is a whole number and nothing else; nothing for signs, other letters and numbers
/// that std::size_t does not hold.
std::optional<std::size_t> parse_whole_number(std::string_view text);

/// The words of a line of text, which are separated by blanks.
std::vector<std::string_view> split_words(std::string_view line);

/// The columns of a line: what is between semicolons or, if there are none, commas, without the
/// blanks around it; else the words.
std::vector<std::string_view> split_columns(std::string_view line);

/// Twelve numbers, row by row [R | t], or sixteen, with 0 0 0 1 as the last row, as a rigid
/// transform; nothing for other counts. Text holds few digits, so a rotation
/// that is off by up to 1e-3 in R·Rᵀ is made exact; nothing where it is off by more, is a mirror
/// image, or a number is not finite.
std::optional<Eigen::Isometry3d> rigid_transform(std::span<const double> rows);

/// The transform in a line of text. Throws std::invalid_argument whose text is what was found in
/// place of the twelve or sixteen numbers of a rigid transform ("11 numbers").
Eigen::Isometry3d parse_rigid_transform(std::string_view line);

/// The lines of a text, without line ends of either kind and without the byte order mark that some
/// editors write before UTF-8.
std::vector<std::string_view> split_lines(std::string_view text);

}  // namespace groundgrid::io
