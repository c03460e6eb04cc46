// Your own point type, read where it lies, and a scan that is not motion-corrected: while the LiDAR
// turns once, the braking vehicle drives on and its nose dips. With a time per point and the poses
// at the begin and the end of the scan, every point is taken from where the LiDAR then was.

#include <Eigen/Geometry>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <groundgrid/adapters/span.hpp>
#include <groundgrid/ground_grid.hpp>
#include <numbers>
#include <vector>

using Pose = Eigen::Isometry3d;

struct MyPoint {
  float x, y, z;       // metres, in the frame of the LiDAR at `time`
  std::uint16_t ring;  // not needed, and not in the way
  double time;         // seconds
};

// Where the vehicle is at a time between 0 s and 0.1 s: 15 m/s, nose going down by 20 degrees/s.
Pose vehicle_at(double time) {
  const double nose_down = 20.0 * std::numbers::pi / 180.0 * time;
  return Eigen::Translation3d(15.0 * time, 0.0, 0.0) *
         Eigen::AngleAxisd(nose_down, Eigen::Vector3d::UnitY());
}

// What a LiDAR that turns once, from behind over the right to the front, records of level ground.
std::vector<MyPoint> synthetic_scan(const Pose& T_base_lidar, double begin, double end) {
  std::vector<MyPoint> points;
  for (int step = 0; step < 2000; ++step) {
    const double time = begin + (end - begin) * step / 2000.0;
    const double azimuth = std::numbers::pi * (step - 1000) / 1000.0;
    const Pose T_map_lidar = vehicle_at(time) * T_base_lidar;
    for (int beam = 0; beam < 64; ++beam) {
      const double down = 0.05 + 0.006 * beam;
      const Eigen::Vector3d ray(std::cos(azimuth), std::sin(azimuth), -std::tan(down));
      const double falls = -(T_map_lidar.linear() * ray).z();
      if (falls < 0.02) continue;  // the ray meets the ground too far away
      const Eigen::Vector3f hit = (ray * (T_map_lidar.translation().z() / falls)).cast<float>();
      points.push_back({hit.x(), hit.y(), hit.z(), static_cast<std::uint16_t>(beam), time});
    }
  }
  return points;
}

double terrain_height(const groundgrid::TerrainView& terrain, double x, double y) {
  return terrain
      .cell(static_cast<int>((x - terrain.min_x_m) / terrain.resolution_m),
            static_cast<int>((y - terrain.min_y_m) / terrain.resolution_m))
      .height;
}

int main() {
  const Pose T_base_lidar(Eigen::Translation3d(1.0, 0.0, 1.73));
  const double begin = 0.0, end = 0.1;
  const std::vector<MyPoint> points = synthetic_scan(T_base_lidar, begin, end);

  groundgrid::SensorScan scan;
  scan.points = groundgrid::view_of(points);  // needs members x, y, z; nothing is copied
  scan.points.time_offset = offsetof(MyPoint, time);
  scan.points.time_type = groundgrid::TimeType::float64;
  scan.T_base_sensor = T_base_lidar;
  scan.time_begin = begin;
  scan.time_end = end;

  std::printf("the terrain 20 m ahead, which is level:\n");
  groundgrid::GroundGrid grid;
  grid.process(scan, vehicle_at(end));
  std::printf("  one pose for all points: %+.2f m\n", terrain_height(grid.terrain(), 20.0, 0.0));
  grid.reset();
  grid.process(
      {.scans = {&scan, 1}, .T_map_base = vehicle_at(end), .T_map_base_begin = vehicle_at(begin)});
  std::printf("  motion-corrected: %+.2f m\n", terrain_height(grid.terrain(), 20.0, 0.0));
}
