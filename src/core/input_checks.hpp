#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <span>

#include "groundgrid/scan.hpp"

namespace groundgrid {

/// Of one call: with more, the squares of one cell's heights could leave 64 bits.
inline constexpr std::size_t kMaxPointsPerCall = std::size_t{1} << 22U;

/// Where base was while a scan was taken.
struct Motion {
  const Eigen::Isometry3d& T_map_base_begin;
  const Eigen::Isometry3d& T_map_base_end;
  bool within_scan;  ///< Whether points with times are to be corrected for the way between.
};

/// Throws std::invalid_argument if offsets and stride do not fit or the data is null.
void check_view(const PointView& view);

/// Throws std::invalid_argument for all that GroundGrid::process() refuses.
void check_input(std::span<const SensorScan> scans, const Motion& motion);

}  // namespace groundgrid
