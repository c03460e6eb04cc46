#pragma once

#include <Eigen/Geometry>
#include <filesystem>

namespace groundgrid::io {

/// Reads the mounting of the LiDAR from a KITTI calib.txt: T_camera_lidar, which the odometry set
/// calls `Tr:`, the tracking set `Tr_velo_cam` and the object set `Tr_velo_to_cam`. Throws Error
/// where the file cannot be read, has no such line, or the line is no rigid transform.
Eigen::Isometry3d read_lidar_calibration(const std::filesystem::path& path);

/// Reads a KITTI-360 dataset's folder `calibration`: T_vehicle_lidar, where the vehicle's frame,
/// that of the dataset's poses, is x ahead, y right, z down. It is made of calib_cam_to_pose.txt
/// (the line image_00) and calib_cam_to_velo.txt. Throws Error as above.
Eigen::Isometry3d read_kitti_360_mounting(const std::filesystem::path& folder);

}  // namespace groundgrid::io
