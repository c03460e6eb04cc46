#include "program/sequence_summary.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "groundgrid/config.hpp"
#include "io/error.hpp"
#include "io/path_checks.hpp"
#include "program/interrupt.hpp"
#include "program/label_file.hpp"
#include "program/scan_reading.hpp"

namespace groundgrid::program {
namespace {

using Json = nlohmann::ordered_json;

void read_scans(SequenceSummary& summary, const Eigen::Matrix3d& R_level_lidar, bool every_scan) {
  ScanSlot slot;
  for (const io::ScanFile& scan : summary.sequence.scans) {
    check_interrupt();
    try {
      read_into_slot(scan, R_level_lidar, slot);
      ++summary.scans_read;
      summary.points_read += slot.size();
      if (!summary.first_scan) summary.first_scan = summary_of(scan, slot);
    } catch (const io::Error& error) {
      summary.unreadable.emplace_back(error.what());
    }
    if (summary.first_scan && !every_scan) return;
  }
}

std::size_t labelled_scans(const io::ScanSequence& sequence) {
  return static_cast<std::size_t>(std::count_if(
      sequence.scans.begin(), sequence.scans.end(),
      [&](const io::ScanFile& scan) { return io::is_there(label_file(sequence.labels(), scan)); }));
}

std::string pose_text(const SequenceSummary& summary) {
  if (!summary.poses)
    return summary.pose_problem.empty() ? "  no poses: single scans\n"
                                        : fmt::format("  ! no poses: {}\n", summary.pose_problem);
  const PoseSummary& poses = *summary.poses;
  std::string text =
      fmt::format("  {} poses, {:.1f} m driven, at most {:.2f} m between two scans\n",
                  poses.in_file, poses.length_m, poses.greatest_step_m);
  if (poses.scans_without > 0)
    text += fmt::format("  ! {} scans have no pose\n", poses.scans_without);
  if (poses.jumps > 0)
    text +=
        fmt::format("  ! the pose jumps by more than {} m {} times; the map starts anew there\n",
                    kPoseJump_m, poses.jumps);
  return text;
}

std::string label_text(const SequenceSummary& summary) {
  if (!summary.scans_with_labels) return "";
  const std::size_t scans = summary.sequence.scans.size();
  const bool all = *summary.scans_with_labels == scans;
  return fmt::format("  {}{} of {} scans have labels\n", all ? "" : "! ",
                     *summary.scans_with_labels, scans);
}

Json pose_json(const PoseSummary& poses) {
  return {{"in_file", poses.in_file},
          {"scans_without", poses.scans_without},
          {"length_m", poses.length_m},
          {"greatest_step_m", poses.greatest_step_m},
          {"jumps", poses.jumps}};
}

}  // namespace

SequenceSummary summary_of(const io::ScanSequence& sequence, const Eigen::Matrix3d& R_level_lidar,
                           bool every_scan) {
  SequenceSummary summary{.sequence = sequence};
  read_scans(summary, R_level_lidar, every_scan);
  if (sequence.plain()) return summary;
  summary.missing_numbers =
      sequence.scans.back().number - sequence.scans.front().number + 1 - sequence.scans.size();
  if (io::is_folder(sequence.labels())) summary.scans_with_labels = labelled_scans(sequence);
  return summary;
}

void add_poses(SequenceSummary& summary, const io::ScanPoses& poses) {
  PoseSummary found{.in_file = poses.size()};
  std::optional<Eigen::Vector3d> last;
  for (const io::ScanFile& scan : summary.sequence.scans) {
    try {
      const Eigen::Vector3d position = poses.pose(scan).translation();
      const double step = last ? (position - *last).norm() : 0.0;
      last = position;
      found.length_m += step;
      found.greatest_step_m = std::max(found.greatest_step_m, step);
      if (step > kPoseJump_m) ++found.jumps;
    } catch (const io::Error&) {
      ++found.scans_without;
    }
  }
  summary.poses = found;
}

std::string to_text(const SequenceSummary& summary) {
  const io::ScanSequence& sequence = summary.sequence;
  const std::size_t scans = sequence.scans.size();
  std::string text = sequence.plain()
                         ? fmt::format("{} scan{}\n", scans, scans == 1 ? "" : "s")
                         : fmt::format("sequence {}: {} scans, {} to {}\n", sequence.name, scans,
                                       sequence.scans.front().name, sequence.scans.back().name);
  if (summary.missing_numbers > 0)
    text += fmt::format("  {} numbers between them are missing\n", summary.missing_numbers);
  if (summary.scans_read > 1)
    text += fmt::format("  {} scans read, {} points, {} a scan\n", summary.scans_read,
                        summary.points_read, summary.points_read / summary.scans_read);
  for (const std::string& problem : summary.unreadable) text += fmt::format("  ! {}\n", problem);
  text += label_text(summary) + pose_text(summary);
  if (summary.first_scan) text += to_text(*summary.first_scan);
  return text;
}

Json to_json(const SequenceSummary& summary) {
  const io::ScanSequence& sequence = summary.sequence;
  return {
      {"sequence", sequence.plain() ? Json(nullptr) : Json(sequence.name)},
      {"folder", sequence.folder.string()},
      {"scans", sequence.scans.size()},
      {"first", sequence.scans.front().name},
      {"last", sequence.scans.back().name},
      {"missing_numbers", summary.missing_numbers},
      {"scans_read", summary.scans_read},
      {"points_read", summary.points_read},
      {"unreadable", summary.unreadable},
      {"scans_with_labels",
       summary.scans_with_labels ? Json(*summary.scans_with_labels) : Json(nullptr)},
      {"poses", summary.poses ? pose_json(*summary.poses) : Json(nullptr)},
      {"pose_problem", summary.pose_problem.empty() ? Json(nullptr) : Json(summary.pose_problem)},
      {"first_scan", summary.first_scan ? to_json(*summary.first_scan) : Json(nullptr)}};
}

}  // namespace groundgrid::program
