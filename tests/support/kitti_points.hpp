#pragma once

#include <cstring>
#include <filesystem>
#include <vector>

#include "io/bin_scan.hpp"

namespace groundgrid::testing {

/// x, y, z and intensity of every point of a KITTI scan.
inline std::vector<float> kitti_points(const std::filesystem::path& path) {
  io::PointCloud cloud;
  io::read_bin_scan(path, io::kKittiLayout, cloud);
  std::vector<float> points(cloud.size() * 4);
  if (!points.empty()) std::memcpy(points.data(), cloud.data.data(), cloud.data.size());
  return points;
}

}  // namespace groundgrid::testing
