#pragma once

#include <sys/types.h>

#include <filesystem>
#include <map>
#include <utility>

#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// The files that a command reads, none of which its output may replace. They are known by device
/// and number, so that neither another way to write a path nor a link hides one.
class InputFiles {
 public:
  /// Nothing where the path is empty or nothing is there.
  void add(const std::filesystem::path& file);

  /// The scans of a sequence, and what a dataset has beside them: poses, calibration, times and
  /// labels.
  void add(const io::ScanSequence& sequence);

  /// Throws UsageError where writing to `output` would replace one of them.
  void keep(const std::filesystem::path& output) const;

 private:
  using Identity = std::pair<dev_t, ino_t>;
  std::map<Identity, std::filesystem::path> known_;
};

}  // namespace groundgrid::program
