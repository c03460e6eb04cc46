#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace groundgrid::program {

/// One scan's row in timing.csv.
struct TimingRow {
  std::string sequence;  ///< Empty for plain files.
  std::string scan;
  std::size_t points;
  double milliseconds;  ///< Of GroundGrid::process() alone.
};

/// timing.csv (sequence,scan,points,milliseconds): the rows of this run and those that earlier runs
/// left for other sequences, or, among plain files, for other scans.
class TimingTable {
 public:
  /// Reads what is there. Throws io::Error where that is no such table.
  explicit TimingTable(std::filesystem::path path);

  void add(const TimingRow& row);

  /// Writes the file, complete or not at all. Throws io::Error where that fails.
  void write() const;

 private:
  // A row as text, with what it is sorted and replaced by.
  struct Line {
    std::string sequence;
    std::string scan;
    std::string text;
  };

  static std::vector<Line> read(const std::filesystem::path& path);

  std::filesystem::path path_;
  std::vector<Line> earlier_;
  std::vector<Line> lines_;
};

}  // namespace groundgrid::program
