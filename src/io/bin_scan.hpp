#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Floats per point in a KITTI scan: x, y, z in metres in the LiDAR's frame, and intensity.
inline constexpr std::size_t kBinFloatsPerPoint = 4;

/// Reads a KITTI scan (.bin: x y z intensity as little-endian 32-bit floats, nothing else) into
/// `points`, whose memory is reused. An empty file is a scan of no points. Throws Error where the
/// file cannot be read, is no whole number of points or does not fit into memory.
void read_bin_scan(const std::filesystem::path& path, std::vector<float>& points);

/// Reads a KITTI scan into a cleared cloud. Throws Error as read_bin_scan does, and where the file
/// begins as one of another format does.
void read_kitti_scan(const std::filesystem::path& path, PointCloud& cloud);

/// The same for a nuScenes scan (.pcd.bin: x y z intensity ring, all 32-bit floats).
void read_nuscenes_scan(const std::filesystem::path& path, PointCloud& cloud);

}  // namespace groundgrid::io
