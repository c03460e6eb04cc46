#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "io/kitti_poses.hpp"
#include "io/scan_sequence.hpp"
#include "program/method_notes.hpp"

namespace groundgrid::program {

/// The poses of a sequence; nothing for single scans, which plain files always are. Throws
/// io::Error where poses are needed and cannot be read.
std::optional<io::KittiPoses> read_poses(const io::ScanSequence& sequence, bool single_scan);

/// The same, throwing io::Error also where a scan of the sequence has no pose.
std::optional<io::KittiPoses> read_every_pose(const io::ScanSequence& sequence, bool single_scan);

/// What became of one scan. The spans live until the next scan.
struct ProcessedScan {
  std::span<const float> points;          ///< As in the file: x y z intensity, sensor frame.
  std::span<const std::uint32_t> labels;  ///< SemanticKITTI numbers, one a point.
  ScanResult result;
  double milliseconds;  ///< Of GroundGrid::process() alone.
};

/// Runs the method over the scans of one sequence in their order. The LiDAR's own frame is base,
/// so the map is in the frame of the first LiDAR pose; with single scans there are no poses and
/// the map is forgotten before each scan. Memory is reused from scan to scan.
class MethodRunner {
 public:
  /// Without poses every scan is a single one. Throws std::runtime_error where memory does not
  /// hold the map.
  MethodRunner(const Config& config, std::optional<io::KittiPoses> poses);

  /// Throws io::Error where the scan cannot be read, holds no points or has no pose. Warns where
  /// the map starts anew.
  ProcessedScan process(const io::ScanFile& scan);

  /// Over all scans so far.
  [[nodiscard]] const MethodNotes& notes() const { return notes_; }

 private:
  GroundGrid grid_;
  std::optional<io::KittiPoses> poses_;  ///< Nothing for single scans.
  MethodNotes notes_;
  std::vector<float> points_;
  std::vector<std::uint32_t> labels_;
};

}  // namespace groundgrid::program
