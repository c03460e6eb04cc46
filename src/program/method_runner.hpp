#pragma once

#include <Eigen/Geometry>
#include <optional>

#include "groundgrid/ground_grid.hpp"
#include "groundgrid/terrain_layers.hpp"
#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"
#include "program/method_notes.hpp"
#include "program/scan_slot.hpp"

namespace groundgrid::program {

/// How the frames of a run hang together. The levelled LiDAR's frame is base.
struct RunFrames {
  /// As InputOptions::R_level_lidar().
  Eigen::Matrix3d R_level_lidar = Eigen::Matrix3d::Identity();
  /// Where the frame of the poses, once it is level, lies in the frame of the terrain.
  Eigen::Isometry3d T_map_level = Eigen::Isometry3d::Identity();
};

/// Runs the method over the scans of one sequence in their order.
class MethodRunner {
 public:
  /// Without poses every scan is a single one: the map is forgotten before it. A scan that the
  /// poses leave out is one, too, in a map of its own. `threads` as GroundGrid has them. Throws
  /// std::runtime_error if memory does not hold the map.
  MethodRunner(const Config& config, int threads, std::optional<io::ScanPoses> poses,
               RunFrames frames = {});

  /// Reads a scan for process(); may run on another thread than it. Throws io::Error.
  void read(const io::ScanFile& scan, ScanSlot& slot) const;

  /// Labels the points of a slot. Throws what reading it threw, io::Error where the scan has no
  /// pose or one that lays the vehicle on its side. Warns where the map starts anew and where no
  /// point lies in the map.
  void process(const io::ScanFile& scan, ScanSlot& slot);

  /// Whether the poses leave this scan out, so that it is not in terrain() and layers().
  [[nodiscard]] bool is_lone(const io::ScanFile& scan) const {
    return poses_ && poses_->leaves_out(scan);
  }

  /// From now on makes the layers of the terrain after each scan, too.
  void make_layers(const TraversabilityLimits& limits) {
    limits_ = limits;
    layers_.emplace();
  }

  /// From now on heights above the ground stay in the slots, too.
  void keep_heights() { keeps_heights_ = true; }

  /// After the last scan; null unless they are to be made.
  [[nodiscard]] const TerrainLayers* layers() const { return layers_ ? &*layers_ : nullptr; }

  /// The map after the last scan.
  [[nodiscard]] TerrainView terrain() const { return grid_.terrain(); }

  /// Over all scans so far.
  [[nodiscard]] const MethodNotes& notes() const { return notes_; }

 private:
  [[nodiscard]] Eigen::Isometry3d pose(const io::ScanFile& scan) const;
  GroundGrid& grid_for(const io::ScanFile& scan);
  /// Once, since all scans of a sensor have the same one or each has another.
  void warn_of_first(const io::ScanFile& scan, const ScanSlot& slot);
  void warn_of_viewpoint(const io::ScanFile& scan, const io::PointCloud& cloud);

  int threads_;
  GroundGrid grid_;
  std::optional<GroundGrid> lone_grid_{};  ///< Of scans without a pose, once there is one.
  std::optional<io::ScanPoses> poses_;     ///< Nothing for single scans.
  RunFrames frames_;
  Eigen::Isometry3d T_map_poses_;
  MethodNotes notes_;
  TraversabilityLimits limits_;
  std::optional<TerrainLayers> layers_;
  bool keeps_heights_ = false;
  bool has_seen_first_ = false;
  bool has_warned_of_viewpoint_ = false;
};

}  // namespace groundgrid::program
