#pragma once

#include <cstddef>
#include <cstdint>
#include <exception>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "io/point_cloud.hpp"
#include "program/label_counts.hpp"

namespace groundgrid::program {

/// One scan on its way from file to file. The memory is reused by later scans.
struct ScanSlot {
  // Filled by reading.
  io::PointCloud cloud{};
  std::vector<float> coordinates{};  ///< Where the cloud's own cannot be used as they are.
  PointView points{};                ///< In the frame of the levelled LiDAR.
  std::exception_ptr problem{};      ///< Why there is no cloud.
  // Filled by processing; one element a point, but heights only where they are to be kept.
  std::vector<std::uint32_t> labels{};       ///< SemanticKITTI numbers.
  std::vector<float> height_above_ground{};  ///< Metres; NaN where unknown.
  LabelCounts counts{};
  double milliseconds = 0.0;  ///< Of GroundGrid::process() alone.

  [[nodiscard]] std::size_t size() const { return points.count; }
};

}  // namespace groundgrid::program
