#pragma once

#include <Eigen/Core>
#include <string>

#include "io/scan_sequence.hpp"
#include "program/scan_slot.hpp"

namespace groundgrid::program {

/// Reads a scan into the slot and turns its points by `R_level_lidar`. Throws io::Error where the
/// file cannot be read or holds no points.
void read_into_slot(const io::ScanFile& scan, const Eigen::Matrix3d& R_level_lidar, ScanSlot& slot);

/// What is to be known of a cloud whose VIEWPOINT is not the origin, a sentence; else empty.
std::string viewpoint_remark(const io::PointCloud& cloud);

/// x, y and z of every point one after another, in memory that is reused.
void copy_coordinates(const PointView& points, std::vector<float>& coordinates);

}  // namespace groundgrid::program
