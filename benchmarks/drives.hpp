#pragma once

#include <Eigen/Geometry>
#include <string>
#include <vector>

#include "groundgrid/scan.hpp"

namespace groundgrid::benchmarks {

/// A scan to be timed, in the frame of a LiDAR 1.73 m above the ground.
struct TimedScan {
  std::vector<float> points;  ///< x, y, z, intensity.
  Eigen::Isometry3d T_map_lidar = Eigen::Isometry3d::Identity();

  [[nodiscard]] std::size_t size() const { return points.size() / 4; }
  [[nodiscard]] SensorScan scan() const;
};

/// Consecutive scans and what they are.
struct Drive {
  std::string source;  ///< "SemanticKITTI 00" or "simulated".
  std::vector<TimedScan> scans;
};

/// Ten real scans where the data is (see GROUNDGRID_DATA), else simulated ones of about as many
/// points. Read once.
const Drive& drive();

}  // namespace groundgrid::benchmarks
