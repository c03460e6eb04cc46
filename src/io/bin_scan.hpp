#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads a KITTI scan (.bin: x y z intensity as little-endian 32-bit floats, nothing else; metres,
/// in the LiDAR's frame) into a cleared cloud. An empty file is a scan of no points. Throws Error
/// where the file cannot be read, is no whole number of points, does not fit into memory or begins
/// as one of another format does.
void read_kitti_scan(const std::filesystem::path& path, PointCloud& cloud);

/// The same for a nuScenes scan (.pcd.bin: x y z intensity ring, all 32-bit floats).
void read_nuscenes_scan(const std::filesystem::path& path, PointCloud& cloud);

}  // namespace groundgrid::io
