#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "io/kitti_poses.hpp"
#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// The least and greatest height of the sensor over the ground that were in use, metres.
struct SensorHeights {
  double least = 0.0;
  double greatest = 0.0;
  bool estimated = false;

  /// "1.73 m above the ground, as given", "1.70 to 1.75 m above the ground, estimated scan by
  /// scan".
  [[nodiscard]] std::string words() const;
};

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
  /// Throws io::Error where poses are needed and cannot be read.
  MethodRunner(const Config& config, const io::ScanSequence& sequence, bool single_scan);

  /// Throws io::Error where the scan cannot be read, holds no points or has no pose.
  ProcessedScan process(const io::ScanFile& scan);

  /// Over all scans so far; nothing before the first.
  [[nodiscard]] const std::optional<SensorHeights>& sensor_heights() const {
    return sensor_heights_;
  }

 private:
  void note_sensor_height(const ScanResult& result);

  GroundGrid grid_;
  std::optional<io::KittiPoses> poses_;  ///< Nothing for single scans.
  std::optional<SensorHeights> sensor_heights_;
  std::vector<float> points_;
  std::vector<std::uint32_t> labels_;
};

}  // namespace groundgrid::program
