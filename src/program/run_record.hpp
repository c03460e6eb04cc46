#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "groundgrid/config.hpp"
#include "groundgrid/ground_grid.hpp"
#include "program/method_notes.hpp"

namespace groundgrid::program {

/// Points by answer.
struct LabelCounts {
  std::uint64_t ground = 0;
  std::uint64_t obstacle = 0;
  std::uint64_t outlier = 0;
  std::uint64_t unknown = 0;

  void add(const ScanResult& result);
  void add(const LabelCounts& other);
};

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
  std::filesystem::path input;
  std::filesystem::path output;
  std::string preset;
  bool single_scan = false;
  Config config{};
  std::vector<SequenceRecord> sequences{};
  std::vector<SkippedSequence> skipped_sequences{};

  /// Segmented scans.
  [[nodiscard]] std::size_t scans() const;
  /// Skipped scans, those of skipped sequences among them.
  [[nodiscard]] std::size_t skipped() const;
};

/// `complete` is true where no scan was skipped; the file itself is written by runs that came to
/// their end only.
nlohmann::ordered_json to_json(const RunRecord& record);

}  // namespace groundgrid::program
