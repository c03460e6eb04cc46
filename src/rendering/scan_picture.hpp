#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "rendering/figure.hpp"

namespace groundgrid::rendering {

/// How the points of one group look.
struct PointStyle {
  std::string name{};
  Color color{};
  double size = 1.0;  ///< Times the usual one.
};

/// A scan whose points belong to groups.
struct ScanPicture {
  std::span<const float> coordinates{};   ///< x, y, z of each point, metres; x ahead, z up.
  std::span<const std::uint8_t> group{};  ///< Of each point: its place in `styles`.
  std::vector<PointStyle> styles{};       ///< Later groups are drawn over earlier ones.
  double range_m = 50.0;                  ///< From the LiDAR to the nearest edge of the plot.
  double sensor_height_m = 1.73;          ///< Of the LiDAR over the ground.
  std::string title{};
  std::string caption{};
};

/// The scan from above, x ahead up, the LiDAR in the middle, with range rings and a scale bar.
/// Throws std::invalid_argument where there are not three coordinates and one group a point.
Image draw_scan_from_above(const ScanPicture& picture, ImageSize size);

/// Throws as above. What every view of a scan checks.
void require_matching(const ScanPicture& picture);

/// The legend of a scan: each group with its share of the points.
std::vector<LegendEntry> legend_of(const ScanPicture& picture);

}  // namespace groundgrid::rendering
