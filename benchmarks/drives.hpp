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

/// The same with every n-th point alone.
Drive thinned(const Drive& drive, std::size_t n);

/// The same with the points of the last n scans together, in the frame of the last, as the last.
Drive merged(const Drive& drive, std::size_t n);

/// The size of a scan, in thousands of points.
enum Kilopoints : int {
  k30 = 30,     ///< Every fourth point of drive().
  k60 = 60,     ///< Every second.
  k124 = 124,   ///< drive().
  k262 = 262,   ///< A simulated LiDAR of 128 beams with 2048 points each, that writes 0, 0, 0 for
                ///< rays without a return, as Ouster's driver does.
  k1000 = 1000  ///< Eight scans of drive() in one.
};

/// A drive whose last scan is of that size. Made once.
const Drive& drive_of(Kilopoints size);

}  // namespace groundgrid::benchmarks
