#pragma once

#include "core/map/elevation_map.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// What hides a point from a sensor.
struct RayRule {
  double tolerance_m = 0.0;     ///< o_t: a ray may dip this far below the map.
  double min_confidence = 0.0;  ///< o_minc: what a cell needs, summed over 5 × 5 cells.
};

/// Whether the line from `sensor` to `point` (window frame) runs free above the map: in no cell
/// that it crosses, the point's own left out, does it dip more than the tolerance o_t below the
/// known height, where the sum of confidence over the 5×5 cells around is at least o_minc.
/// Free, too, where sensor or point lies outside the window: nothing is known of the whole line.
/// A point cannot be hidden by the cell it lies in: that cell is what it tells us about.
bool has_line_of_sight(const ElevationMap& map, const Point3f& sensor, const Point3f& point,
                       const RayRule& rule);

}  // namespace groundgrid
