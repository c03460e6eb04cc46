#include "support/ray_caster.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace groundgrid::testing {
namespace {

constexpr double kScanTime_s = 0.1;
constexpr double kFoot_m = 0.35;

double radians(double degrees) { return degrees * std::numbers::pi / 180.0; }

struct Hit {
  double range = std::numeric_limits<double>::infinity();
  Truth truth = Truth::ground;
};

/// Range at which a ray enters a box; infinite where it misses it.
double range_to(const SolidBox& box, const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) {
  double enter = 0.0;
  double leave = std::numeric_limits<double>::infinity();
  for (int axis = 0; axis < 3; ++axis) {
    double a = (box.min[axis] - origin[axis]) / ray[axis];
    double b = (box.max[axis] - origin[axis]) / ray[axis];
    if (a > b) std::swap(a, b);
    enter = std::max(enter, a);
    leave = std::min(leave, b);
  }
  return enter < leave ? enter : std::numeric_limits<double>::infinity();
}

Hit cast(const Scene& scene, const Eigen::Vector3d& origin, const Eigen::Vector3d& ray) {
  Hit hit;
  const double fall = scene.slope_x * ray.x() - ray.z();
  const double above = origin.z() - scene.slope_x * origin.x();
  if (fall > 0.0) hit.range = above / fall;
  for (const SolidBox& box : scene.boxes) {
    const double range = range_to(box, origin, ray);
    if (range >= hit.range) continue;
    const Eigen::Vector3d point = origin + range * ray;
    const bool low = point.z() - scene.slope_x * point.x() < kFoot_m;
    hit = {range, box.is_ground ? Truth::ground : low ? Truth::foot : Truth::obstacle};
  }
  return hit;
}

Eigen::Isometry3d interpolate(const Eigen::Isometry3d& begin, const Eigen::Isometry3d& end,
                              double share) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() = Eigen::Quaterniond(begin.linear())
                        .slerp(share, Eigen::Quaterniond(end.linear()))
                        .toRotationMatrix();
  result.translation() = (1.0 - share) * begin.translation() + share * end.translation();
  return result;
}

}  // namespace

PointView SimulatedScan::view() const {
  PointView view;
  view.data = reinterpret_cast<const std::byte*>(records.data());
  view.count = records.size();
  view.stride_bytes = sizeof(Record);
  view.x_offset = offsetof(Record, x);
  view.y_offset = offsetof(Record, y);
  view.z_offset = offsetof(Record, z);
  view.time_offset = offsetof(Record, time);
  return view;
}

std::vector<float> SimulatedScan::packed() const {
  std::vector<float> xyz;
  xyz.reserve(records.size() * 3);
  for (const Record& record : records) xyz.insert(xyz.end(), {record.x, record.y, record.z});
  return xyz;
}

SimulatedScan cast_scan(const Scene& scene, const SpinningSensor& sensor,
                        const Eigen::Isometry3d& T_map_base_begin,
                        const Eigen::Isometry3d& T_map_base_end,
                        const Eigen::Isometry3d& T_base_sensor, unsigned seed) {
  SimulatedScan scan;
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> noise(-sensor.noise_m, sensor.noise_m);
  for (int azimuth = 0; azimuth < sensor.azimuths; ++azimuth) {
    const double share = static_cast<double>(azimuth) / sensor.azimuths;
    const Eigen::Isometry3d T_map_sensor =
        interpolate(T_map_base_begin, T_map_base_end, share) * T_base_sensor;
    const double yaw = radians(sensor.first_azimuth_deg + 360.0 * share);
    for (int beam = 0; beam < sensor.beams; ++beam) {
      const double pitch = radians(sensor.lowest_deg + (sensor.highest_deg - sensor.lowest_deg) *
                                                           beam / (sensor.beams - 1));
      const Eigen::Vector3d ray(std::cos(pitch) * std::cos(yaw), std::cos(pitch) * std::sin(yaw),
                                std::sin(pitch));
      const Hit hit = cast(scene, T_map_sensor.translation(), T_map_sensor.linear() * ray);
      if (!(hit.range <= sensor.max_range_m)) continue;
      const Eigen::Vector3f point = ((hit.range + noise(random)) * ray).cast<float>();
      scan.records.push_back({point.x(), point.y(), point.z(), 0.0F, share * kScanTime_s});
      scan.truth.push_back(hit.truth);
    }
  }
  return scan;
}

SimulatedScan cast_scan(const Scene& scene, const SpinningSensor& sensor,
                        const Eigen::Isometry3d& T_map_base, const Eigen::Isometry3d& T_base_sensor,
                        unsigned seed) {
  return cast_scan(scene, sensor, T_map_base, T_map_base, T_base_sensor, seed);
}

void Score::add(const Score& other) {
  ground_points += other.ground_points;
  obstacle_points += other.obstacle_points;
  ground_found += other.ground_found;
  obstacle_found += other.obstacle_found;
  outliers += other.outliers;
  unknown += other.unknown;
}

double Score::ground_recall() const {
  return static_cast<double>(ground_found) / static_cast<double>(ground_points);
}

double Score::obstacle_recall() const {
  return static_cast<double>(obstacle_found) / static_cast<double>(obstacle_points);
}

Score score(std::span<const Label> labels, const std::vector<Truth>& truth, std::size_t first) {
  Score result;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const Label label = labels[first + i];
    result.outliers += label == Label::outlier ? 1 : 0;
    result.unknown += label == Label::unknown ? 1 : 0;
    if (truth[i] == Truth::ground) {
      ++result.ground_points;
      result.ground_found += label == Label::ground ? 1 : 0;
    } else if (truth[i] == Truth::obstacle) {
      ++result.obstacle_points;
      result.obstacle_found += label == Label::obstacle ? 1 : 0;
    }
  }
  return result;
}

Eigen::Isometry3d pose(double x, double y, double z, double yaw_deg) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.linear() =
      Eigen::AngleAxisd(radians(yaw_deg), Eigen::Vector3d::UnitZ()).toRotationMatrix();
  result.translation() << x, y, z;
  return result;
}

}  // namespace groundgrid::testing
