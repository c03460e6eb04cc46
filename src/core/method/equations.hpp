#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "groundgrid/config.hpp"

/// Eq. 1 to 8 of the paper, one function each.
namespace groundgrid {

/// Height and confidence of one cell of the map: g and c.
struct CellEstimate {
  float height = 0.0F;      ///< Metres above the z origin.
  float confidence = 0.0F;  ///< 0 to 1.
};

/// Eq. 1: t_v = d_sf · d, at least t_minv: the variance in m² below which a cell at this distance
/// in metres from the sensor is ground.
inline double variance_threshold(double distance_m, const Config& config) {
  return std::max(config.paper_only.variance_distance_factor * distance_m,
                  config.paper_only.min_variance_threshold);
}

/// Eq. 2: n = atan(R / d) / d_pv: the points that one beam leaves in a cell on open ground.
inline double expected_points(double distance_m, const Config& config) {
  const double degrees = std::atan2(config.map.resolution_m, distance_m) * 180.0 / std::numbers::pi;
  return degrees / config.paper_only.azimuth_resolution_deg;
}

/// Eq. 3: h = Σ(P ∘ M) / ΣP, from the sums over a patch of point counts P and of lowest heights M
/// times P.
inline float ground_elevation(float sum_points_lowest, float sum_points) {
  return sum_points_lowest / sum_points;
}

/// Eq. 4: q = ΣP / s, clamped to [0, 1].
inline float observation_confidence(float sum_points, const Config& config) {
  return std::clamp(sum_points / static_cast<float>(config.map.confidence_point_scale), 0.0F, 1.0F);
}

/// Eq. 5: g ← (q · h + c · g) / (q + c); the height stays if both confidences are 0.
inline float fused_height(const CellEstimate& known, float h, float q) {
  const float weight = q + known.confidence;
  return weight > 0.0F ? (q * h + known.confidence * known.height) / weight : known.height;
}

/// Eq. 6: c ← ½ (q / 2 + c).
inline float fused_confidence(float c, float q) { return 0.5F * (0.5F * q + c); }

/// End of III-D, of cells that are not ground: "If h is below the known ground level we update it
/// and we increase the confidence by a small amount", up to one half.
inline CellEstimate lowered_by_obstacle(const CellEstimate& known, float h) {
  if (h >= known.height) return known;
  return {h, std::min(known.confidence + 0.1F, 0.5F)};
}

/// Eq. 7: g ← (1 − c) · Σ(C ∘ G) / ΣC + c · g, from the sums over 3 × 3 cells of the confidences C
/// and of heights G times C; the height stays if ΣC is 0.
inline float interpolated_height(const CellEstimate& known, float sum_confidence,
                                 float sum_confidence_height) {
  if (!(sum_confidence > 0.0F)) return known.height;
  return (1.0F - known.confidence) * (sum_confidence_height / sum_confidence) +
         known.confidence * known.height;
}

/// Less confidence than this becomes 0: subnormal numbers, after some three hundred scans that show
/// no ground, would make a vehicle that stands still slower and slower.
constexpr float kForgotten = 1e-30F;

/// Eq. 8: c ← c − c / θ.
inline float decayed_confidence(float c, float theta) {
  const float decayed = c - c / theta;
  return decayed < kForgotten ? 0.0F : decayed;
}

}  // namespace groundgrid
