#include "simulation/simulated_drive.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "simulation/random.hpp"

namespace groundgrid::simulation {
namespace {

DriveOptions checked(DriveOptions options) {
  if (options.sensors.empty()) throw std::invalid_argument("a drive needs sensors");
  return options;
}

}  // namespace

std::size_t scans_of(const DriveOptions& options, std::size_t sensor) {
  const double share = options.sensors[sensor].rate_hz / options.sensors.front().rate_hz;
  return std::max<std::size_t>(
      1, static_cast<std::size_t>(std::lround(static_cast<double>(options.scans) * share)));
}

SimulatedDrive::SimulatedDrive(DriveOptions options)
    : options_(checked(std::move(options))),
      speed_mps_(scene_speed_mps(options_.scene)),
      length_m_(static_cast<double>(options_.scans) * speed_mps_ /
                options_.sensors.front().rate_hz),
      runner_(options_.threads),
      scene_(make_scene(options_.scene, options_.seed, length_m_)),
      terrain_(*scene_.path, length_m_, scene_.ground, runner_),
      drive_(scene_, terrain_, options_.seed),
      world_(scene_, terrain_) {}

double SimulatedDrive::time_s(std::size_t sensor, std::size_t scan) const {
  return static_cast<double>(scan) / options_.sensors[sensor].rate_hz;
}

Eigen::Isometry3d SimulatedDrive::pose(std::size_t sensor, std::size_t scan) const {
  return drive_.pose(time_s(sensor, scan)) * options_.sensors[sensor].T_base_sensor();
}

PoseErrors SimulatedDrive::pose_errors(std::size_t sensor) const {
  const double metres_per_scan = speed_mps_ / options_.sensors[sensor].rate_hz;
  return PoseErrors({options_.pose_noise_m, options_.pose_drift_m * metres_per_scan},
                    options_.seed);
}

Scanner SimulatedDrive::scanner(std::size_t sensor) {
  // Sensors of one drive have noise of their own.
  const std::uint64_t seed = sensor == 0 ? options_.seed : hash({options_.seed, 5, sensor});
  return {world_, drive_, options_.sensors[sensor], options_.motion, seed, runner_};
}

}  // namespace groundgrid::simulation
