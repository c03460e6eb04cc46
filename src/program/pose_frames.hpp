#pragma once

#include <Eigen/Geometry>

#include "io/scan_poses.hpp"
#include "io/scan_sequence.hpp"

namespace groundgrid::program {

/// Turns the frame of the poses into one whose z is up. Poses that begin with a LiDAR that is not
/// turned at all are relative to that LiDAR, as KITTI's and those of LiDAR odometry are: their
/// frame is tilted as the LiDAR is. All others are in a map whose z is up already.
Eigen::Isometry3d T_level_poses(const io::ScanPoses& poses, const Eigen::Matrix3d& R_level_lidar);

/// Warns where a drive goes up or down more than ahead, as it does where a camera's poses are
/// taken for a LiDAR's.
void warn_of_climb(const io::ScanPoses& poses, const io::ScanSequence& sequence);

}  // namespace groundgrid::program
