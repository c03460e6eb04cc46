#pragma once

#include <cstddef>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "groundgrid/config.hpp"
#include "program/arguments.hpp"
#include "program/label_counts.hpp"
#include "program/method_notes.hpp"

namespace groundgrid::program {

/// A scan that --keep-going passed over.
struct SkippedScan {
  std::filesystem::path file;
  std::string reason;
};

/// What a run did with one sequence.
struct SequenceRecord {
  std::string name;              ///< Empty for plain files.
  std::filesystem::path folder;  ///< Where the scans came from.
  std::size_t scans = 0;         ///< Segmented, those skipped not among them.
  LabelCounts counts{};
  MethodNotes notes{};
  std::vector<SkippedScan> skipped{};
  std::filesystem::path terrain{};  ///< Relative to the output; empty where none was written.
};

/// A sequence that --keep-going passed over as a whole: its poses cannot be used.
struct SkippedSequence {
  std::string name;
  std::filesystem::path folder;
  std::size_t scans = 0;
  std::string reason;
};

/// What run.json says about a run.
struct RunRecord {
  Arguments arguments{};
  std::filesystem::path input;
  std::filesystem::path output;
  std::filesystem::path poses{};  ///< Of --poses; empty where the sequences' own were used.
  std::string preset;
  bool single_scan = false;
  Config config{};
  int threads = 1;  ///< Of the method; 0: one per core.
  std::vector<SequenceRecord> sequences{};
  std::vector<SkippedSequence> skipped_sequences{};
  double seconds = 0.0;  ///< From the first scan's reading to the last one's writing.

  /// Segmented scans.
  [[nodiscard]] std::size_t scans() const;
  /// Points with another label than unknown.
  [[nodiscard]] std::size_t labelled() const;
  /// Segmented scans a second, reading and writing included.
  [[nodiscard]] double scans_per_second() const;
  /// Skipped scans, those of skipped sequences among them.
  [[nodiscard]] std::size_t skipped() const;
};

/// `complete` is true where no scan was skipped; the file itself is written by runs that came to
/// their end only.
nlohmann::ordered_json to_json(const RunRecord& record);

}  // namespace groundgrid::program
