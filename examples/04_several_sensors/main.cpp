// Two LiDARs on one vehicle, one at the front and one at the rear, both tilted down. Each brings
// its points in its own frame and says where it is mounted; the map is one.

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <groundgrid/adapters/span.hpp>
#include <groundgrid/ground_grid.hpp>
#include <limits>
#include <numbers>
#include <span>
#include <vector>

using Pose = Eigen::Isometry3d;

struct Point {
  float x, y, z;
};

// A mounting on the vehicle's middle axis. Base is on the ground, x forward, z up.
Pose mounting(double x, double z, double yaw_deg, double tilt_deg) {
  const double degree = std::numbers::pi / 180.0;
  return Eigen::Translation3d(x, 0.0, z) *
         Eigen::AngleAxisd(yaw_deg * degree, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(tilt_deg * degree, Eigen::Vector3d::UnitY());
}

// What a LiDAR that looks 60 degrees to either side sees of level ground and of a wall 10 m behind
// the vehicle.
std::vector<Point> synthetic_scan(const Pose& T_base_sensor) {
  const Eigen::Vector3d origin = T_base_sensor.translation();
  std::vector<Point> points;
  for (int beam = 0; beam < 64; ++beam)
    for (int step = -300; step <= 300; ++step) {
      const double down = -0.1 + 0.006 * beam, azimuth = std::numbers::pi / 900.0 * step;
      const Eigen::Vector3d ray(std::cos(azimuth), std::sin(azimuth), -std::tan(down));
      const Eigen::Vector3d in_base = T_base_sensor.linear() * ray;
      double distance =
          in_base.z() < -0.02 ? -origin.z() / in_base.z() : std::numeric_limits<double>::infinity();
      if (in_base.x() < 0.0) distance = std::min(distance, (-10.0 - origin.x()) / in_base.x());
      if (!std::isfinite(distance)) continue;
      const Eigen::Vector3f point = (distance * ray).cast<float>();
      points.push_back({point.x(), point.y(), point.z()});
    }
  return points;
}

void print(const char* name, std::span<const groundgrid::Label> labels) {
  const auto ground = std::count(labels.begin(), labels.end(), groundgrid::Label::ground);
  std::printf("%s: %zu points, %.1f %% ground\n", name, labels.size(),
              100.0 * static_cast<double>(ground) / static_cast<double>(labels.size()));
}

int main() {
  const Pose T_base_front = mounting(2.0, 0.8, 0.0, 5.0);
  const Pose T_base_rear = mounting(-1.5, 1.2, 180.0, 8.0);
  const std::vector<Point> front_points = synthetic_scan(T_base_front);
  const std::vector<Point> rear_points = synthetic_scan(T_base_rear);

  std::array<groundgrid::SensorScan, 2> scans;
  scans[0].points = groundgrid::view_of(front_points);
  scans[0].T_base_sensor = T_base_front;
  scans[1].points = groundgrid::view_of(rear_points);
  scans[1].T_base_sensor = T_base_rear;

  groundgrid::GroundGrid grid;
  const Pose T_map_base = Pose::Identity();
  const groundgrid::ScanResult result = grid.process({.scans = scans, .T_map_base = T_map_base});

  // The labels of the first scan come first, then those of the second.
  print("front", result.labels.first(front_points.size()));
  print("rear", result.labels.subspan(front_points.size()));
}
