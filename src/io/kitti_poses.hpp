#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// The poses of the LiDAR along a KITTI sequence, in the frame of the LiDAR at scan 0.
///
/// poses.txt holds the camera's poses, one a line: the line with index k (from 0) belongs to the
/// scan with the number k, whether or not all scans are on disk.
class KittiPoses {
 public:
  /// Reads both files and turns each camera pose P into Tr⁻¹·P·Tr. Throws Error where a file
  /// cannot be read or a line is no rigid transform.
  KittiPoses(std::filesystem::path poses, const std::filesystem::path& calibration);

  [[nodiscard]] std::size_t size() const { return lidar_poses_.size(); }

  /// T_map_lidar of the scan with that number. Throws Error where the file ends before its line.
  [[nodiscard]] const Eigen::Isometry3d& pose(std::size_t scan_number) const;

 private:
  std::filesystem::path path_;
  std::vector<Eigen::Isometry3d> lidar_poses_;
};

}  // namespace groundgrid::io
