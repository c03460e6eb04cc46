#pragma once

#include <cstdint>

namespace groundgrid {

/// The answer for one point.
enum class Label : std::uint8_t {
  /// No answer: NaN or infinite point, x = y = z = 0 (a ray without a return), outside the map, too
  /// near to the sensor or on the own vehicle.
  unknown = 0,
  ground,    ///< On the terrain surface (paper III-F).
  obstacle,  ///< Above the terrain surface (paper III-F).
  outlier,   ///< No line of sight from the sensor: a reflection below the ground (paper III-A).
};

}  // namespace groundgrid
