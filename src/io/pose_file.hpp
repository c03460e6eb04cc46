#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// The poses of a file, in the order of its lines, and their times where it has some.
struct PoseList {
  std::vector<Eigen::Isometry3d> poses{};
  std::vector<double> times{};  ///< Seconds, strictly increasing; empty for KITTI's forms.
  /// Of the scans that the poses belong to, strictly increasing; of KITTI-360's form only.
  std::vector<std::size_t> numbers{};
};

/// Reads poses in KITTI's form: the twelve numbers of [R | t], row by row, or the sixteen of
/// a 4 x 4 matrix, one pose a line. Throws
/// Error, with the line, where the file cannot be read or a line is no rigid transform.
PoseList read_kitti_poses(const std::filesystem::path& path);

/// Reads poses in any of these forms, told apart by the first line:
///  - KITTI, as above;
///  - KITTI-360: the number of the scan before those of the pose; not every scan has a line;
///  - TUM: time tx ty tz qx qy qz qw, seconds and metres;
///  - ASL (EuRoC): time,tx,ty,tz,qw,qx,qy,qz and maybe more, with commas. Times without a decimal
///    point are nanoseconds. If a header has a name ending in w in the eighth column, the
///    quaternion is in TUM's order.
/// Lines that begin with '#' do not count, nor does a header without it. Throws Error, with the
/// line, if the file cannot be read, has no pose, a line is none, a quaternion is further than 1e-3
/// from length 1, or a time or number is not later than the one before.
PoseList read_pose_file(const std::filesystem::path& path);

/// Reads a times.txt: seconds, one scan a line. Throws Error where a line is no finite number.
std::vector<double> read_scan_times(const std::filesystem::path& path);

}  // namespace groundgrid::io
