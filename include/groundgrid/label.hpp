#pragma once

#include <cstdint>

namespace groundgrid {

/// The answer for one point.
enum class Label : std::uint8_t {
  unknown = 0,  ///< No answer: NaN or infinite point, outside the map, or on the own vehicle.
  ground,       ///< On the terrain surface (paper III-F).
  obstacle,     ///< Above the terrain surface (paper III-F).
  outlier,      ///< No line of sight from the sensor: a reflection below the ground (paper III-A).
};

}  // namespace groundgrid
