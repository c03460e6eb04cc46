#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// The poses of a file, in the order of its lines, and their times where it has some.
struct PoseList {
  std::vector<Eigen::Isometry3d> poses{};
  std::vector<double> times{};  ///< Seconds, strictly increasing; empty for KITTI's form.
};

/// Reads poses in KITTI's form: the twelve numbers of [R | t], row by row, one pose a line. Throws
/// Error, with the line, where the file cannot be read or a line is no rigid transform.
PoseList read_kitti_poses(const std::filesystem::path& path);

/// Reads poses in KITTI's form or in that of TUM (time tx ty tz qx qy qz qw, seconds and metres),
/// told apart by the first line. Lines that begin with '#' do not count. Throws Error, with the
/// line, where the file cannot be read, has no pose, a line is none, a quaternion is further than
/// 1e-3 from length 1, or a time is not later than the one before.
PoseList read_pose_file(const std::filesystem::path& path);

/// Reads a times.txt: seconds, one scan a line. Throws Error where a line is no finite number.
std::vector<double> read_scan_times(const std::filesystem::path& path);

}  // namespace groundgrid::io
