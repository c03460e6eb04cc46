#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// The rest of a file as text, one record a line, numbers separated by blanks. Blank lines do not
/// count.
class TextRecords {
 public:
  /// Reads from the position of the file to its end, or so many bytes of it.
  explicit TextRecords(InputFile& file,
                       std::size_t most_bytes = std::numeric_limits<std::size_t>::max());

  /// The next line without taking it, whose number is line() + 1; empty at the end.
  [[nodiscard]] std::string_view peek();
  [[nodiscard]] std::size_t line() const { return line_; }

  /// How many lines there are yet.
  [[nodiscard]] std::size_t count() const;

  /// Makes blanks of each of these letters in the lines to come.
  void make_blank(std::string_view letters);

  /// Skips lines. Throws Error where there are fewer.
  void skip(std::size_t records);

  /// Reads the points of a cloud whose fields and shape are known. Floats may be nan and inf, whole
  /// numbers may be written 3.0 or 3e0. Lists, a count and so many numbers, are passed over: before
  /// each of the fields (by index) in `lists`, which are in order, or behind the last. Throws
  /// Error, with the line, where there are fewer points than the header promises or a line is no
  /// point of these fields.
  void read(PointCloud& cloud, std::span<const std::size_t> lists = {});

  /// Throws Error where there are further lines.
  void require_end();

 private:
  [[nodiscard]] std::string_view next_line();
  void read_record(std::string_view line, const PointCloud& cloud,
                   std::span<const std::size_t> lists, std::byte* record) const;
  void skip_list(std::string_view& line) const;

  InputFile& file_;
  std::string text_;
  std::string_view rest_;
  std::size_t line_;  ///< Number of the last line that was taken.
};

/// The records of a cloud as text, each number in the fewest digits that give it again.
std::string text_of_records(const PointCloud& cloud);

}  // namespace groundgrid::io
