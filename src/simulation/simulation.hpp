#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <vector>

#include "simulation/simulated_drive.hpp"

namespace groundgrid::simulation {

/// Called after each scan with the index of its sensor and the number of its points.
using ScanListener = std::function<void(std::size_t sensor, std::size_t points)>;

/// Simulates a drive and writes what each sensor measures to a folder of its own (see
/// SequenceWriter). Throws io::Error where it cannot write and std::invalid_argument where there is
/// no such scene, no sensor, or not a folder for each.
void simulate_drive(const DriveOptions& options, const std::vector<std::filesystem::path>& folders,
                    const ScanListener& listener);

}  // namespace groundgrid::simulation
