#pragma once

#include <cstddef>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "program/scan_summary.hpp"

namespace groundgrid::program {

/// What the poses of a sequence say.
struct PoseSummary {
  std::size_t in_file = 0;
  std::size_t scans_without = 0;
  double length_m = 0.0;         ///< Driven between the scans.
  double greatest_step_m = 0.0;  ///< Between two scans that follow each other.
  std::size_t jumps = 0;         ///< Steps beyond kPoseJump_m.
};

/// What is in one sequence of scans.
struct SequenceSummary {
  io::ScanSequence sequence;
  std::optional<ScanSummary> first_scan{};  ///< Of the first scan that can be read.
  std::size_t scans_read = 0;
  std::size_t points_read = 0;                     ///< In the scans that were read.
  std::vector<std::string> unreadable{};           ///< What reading a scan said.
  std::size_t missing_numbers = 0;                 ///< Between the first and the last scan.
  std::optional<std::size_t> scans_with_labels{};  ///< Nothing where there is no labels folder.
  std::optional<PoseSummary> poses{};
  std::string pose_problem{};  ///< Why there are none.
};

/// Looks at the files, and into the first scan or, with `every_scan`, into all.
/// `R_level_lidar` is that of InputOptions.
SequenceSummary summary_of(const io::ScanSequence& sequence, const Eigen::Matrix3d& R_level_lidar,
                           bool every_scan);

/// Adds what the poses say.
void add_poses(SequenceSummary& summary, const io::ScanPoses& poses);

/// For people: a paragraph.
std::string to_text(const SequenceSummary& summary);
nlohmann::ordered_json to_json(const SequenceSummary& summary);

}  // namespace groundgrid::program
