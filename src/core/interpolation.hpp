#pragma once

#include <cstdint>
#include <vector>

#include "core/elevation_map.hpp"

namespace groundgrid {

/// Eq. 7: the height of a cell without ground, from the sums over its 3×3 neighbourhood (itself
/// included) of confidence and of confidence times height. Where nothing around is known the
/// height stays.
inline float interpolated_height(float height, float confidence, float sum_confidence,
                                 float sum_weighted_height) {
  if (!(sum_confidence > 0.0F)) return height;
  return (1.0F - confidence) * (sum_weighted_height / sum_confidence) + confidence * height;
}

/// Less confidence than this is none.
constexpr float kForgotten = 1e-30F;

/// Eq. 8: the confidence of a cell in which a scan showed no ground. After some three hundred such
/// scans it is forgotten: subnormal numbers would make a vehicle that stands still slower and
/// slower.
inline float decayed_confidence(float confidence, float decay) {
  const float decayed = confidence - confidence / decay;
  return decayed < kForgotten ? 0.0F : decayed;
}

/// Terrain interpolation, paper III-E: spirals outward from the sensor's cell over all cells
/// without ground in this scan; each sees what the ones before it have become.
void interpolate(const std::vector<std::uint8_t>& is_ground, int sensor_column, int sensor_row,
                 const Config& config, ElevationMap& map);

}  // namespace groundgrid
