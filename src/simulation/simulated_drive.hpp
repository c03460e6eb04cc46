#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "core/parallel.hpp"
#include "simulation/drive.hpp"
#include "simulation/echo.hpp"
#include "simulation/pose_errors.hpp"
#include "simulation/scanner.hpp"
#include "simulation/scene.hpp"
#include "simulation/sensors.hpp"
#include "simulation/terrain.hpp"

namespace groundgrid::simulation {

/// A drive to be simulated.
struct DriveOptions {
  std::string scene = "urban";
  std::vector<Sensor> sensors{};  ///< All on the same vehicle.
  std::size_t scans = 200;        ///< Of the first sensor; the others go on for as long.
  std::uint64_t seed = 1;
  Motion motion = Motion::corrected;
  int threads = 0;  ///< 0: one for each core. Changes no bit of the result.
  /// Standard deviation of the error of each pose in poses.txt but the first, in each direction.
  double pose_noise_m = 0.0;
  /// The same of what adds up from scan to scan, for each metre driven.
  double pose_drift_m = 0.0;
};

/// How many scans a sensor of the drive makes.
std::size_t scans_of(const DriveOptions& options, std::size_t sensor);

/// A drive in memory: the world, the way through it, and what is on the vehicle.
class SimulatedDrive {
 public:
  /// Throws std::invalid_argument where there is no such scene or no sensor.
  explicit SimulatedDrive(DriveOptions options);
  ~SimulatedDrive() = default;
  // Its parts know where the others are.
  SimulatedDrive(const SimulatedDrive&) = delete;
  SimulatedDrive& operator=(const SimulatedDrive&) = delete;
  SimulatedDrive(SimulatedDrive&&) = delete;
  SimulatedDrive& operator=(SimulatedDrive&&) = delete;

  [[nodiscard]] const DriveOptions& options() const { return options_; }
  [[nodiscard]] World& world() { return world_; }
  [[nodiscard]] TileRunner& runner() { return runner_; }

  /// When a scan of a sensor is taken, seconds after the first one.
  [[nodiscard]] double time_s(std::size_t sensor, std::size_t scan) const;
  /// T_world_sensor in the middle of a scan.
  [[nodiscard]] Eigen::Isometry3d pose(std::size_t sensor, std::size_t scan) const;
  [[nodiscard]] PoseErrors pose_errors(std::size_t sensor) const;
  /// Sends out the rays of one sensor. The drive must outlive it; one scanner at a time may scan.
  [[nodiscard]] Scanner scanner(std::size_t sensor);

 private:
  DriveOptions options_;
  double speed_mps_;
  double length_m_;
  TileRunner runner_;
  Scene scene_;
  Terrain terrain_;
  Drive drive_;
  World world_;
};

}  // namespace groundgrid::simulation
