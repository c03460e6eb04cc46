#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "simulation/scanner.hpp"
#include "simulation/sensors.hpp"

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

/// Called after each scan with the index of its sensor and the number of its points.
using ScanListener = std::function<void(std::size_t sensor, std::size_t points)>;

/// How many scans a sensor of the drive makes.
std::size_t scans_of(const DriveOptions& options, std::size_t sensor);

/// Simulates a drive and writes what each sensor measures to a folder of its own (see
/// SequenceWriter). Throws io::Error where it cannot write and std::invalid_argument where there is
/// no such scene, no sensor, or not a folder for each.
void simulate_drive(const DriveOptions& options, const std::vector<std::filesystem::path>& folders,
                    const ScanListener& listener);

}  // namespace groundgrid::simulation
