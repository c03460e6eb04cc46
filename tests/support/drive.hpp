#pragma once

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <vector>

#include "core/map/cell_statistics.hpp"
#include "groundgrid/ground_grid.hpp"
#include "support/ray_caster.hpp"

namespace groundgrid::testing {

/// Points of one sensor that stands in base (no mounting) or on it, and the vehicle's pose.
struct DriveScan {
  std::vector<float> points;
  std::size_t floats_per_point = 3;
  Eigen::Isometry3d T_map_base = Eigen::Isometry3d::Identity();
  std::optional<Eigen::Isometry3d> T_base_sensor{};

  [[nodiscard]] std::size_t size() const { return points.size() / floats_per_point; }
  [[nodiscard]] SensorScan scan() const;
};

/// A street with houses, parked cars and a kerb, driven along at 0.75 m a scan. The points are in
/// the frame of a sensor 1.75 m above the ground. All poses have few mantissa bits, so that moving
/// them by a vector of powers of two is exact.
std::vector<DriveScan> street_drive(int scans, const SpinningSensor& sensor = {});

/// All that a drive leaves: answers of every scan, one after another, and the map's layers after
/// the last.
struct DriveResult {
  std::vector<Label> labels;
  std::vector<float> height_above_ground;
  std::vector<float> terrain_height;
  std::vector<float> terrain_confidence;
  std::vector<CellStatistics> terrain_statistics;
};

DriveResult run_drive(GroundGrid& grid, const std::vector<DriveScan>& drive);
DriveResult run_drive(const Config& config, const std::vector<DriveScan>& drive, int threads = 1);

/// Compares bit by bit, NaN included.
::testing::AssertionResult same_bits(const DriveResult& a, const DriveResult& b);

/// The same without the map's layers.
::testing::AssertionResult same_answers(const DriveResult& a, const DriveResult& b);

/// The share of labels that differ.
double share_different(const std::vector<Label>& a, const std::vector<Label>& b);

}  // namespace groundgrid::testing
