#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "simulation/scanner.hpp"
#include "simulation/sensors.hpp"

namespace groundgrid::simulation {

/// A drive to be simulated.
struct DriveOptions {
  std::string scene = "urban";
  Sensor sensor{};
  std::size_t scans = 200;
  std::uint64_t seed = 1;
  Motion motion = Motion::corrected;
  int threads = 0;  ///< 0: one for each core. Changes no bit of the result.
  /// Standard deviation of the error of each pose in poses.txt but the first, in each direction.
  double pose_noise_m = 0.0;
  /// The same of what adds up from scan to scan, for each metre driven.
  double pose_drift_m = 0.0;
};

/// Called after each scan with the number of its points.
using ScanListener = std::function<void(std::size_t points)>;

/// Simulates a drive and writes it to `folder` (see SequenceWriter). Throws io::Error where it
/// cannot write and std::invalid_argument where there is no such scene.
void simulate_drive(const DriveOptions& options, const std::filesystem::path& folder,
                    const ScanListener& listener);

}  // namespace groundgrid::simulation
