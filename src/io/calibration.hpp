#pragma once

#include <Eigen/Geometry>
#include <filesystem>

namespace groundgrid::io {

/// Reads the mounting of the LiDAR from a KITTI calib.txt: T_camera_lidar, which the odometry set
/// calls `Tr:`, the tracking set `Tr_velo_cam` and the object set `Tr_velo_to_cam`. Throws Error
/// where the file cannot be read, has no such line, or the line is no rigid transform.
Eigen::Isometry3d read_lidar_calibration(const std::filesystem::path& path);

}  // namespace groundgrid::io
