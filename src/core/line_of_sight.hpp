#pragma once

#include "core/elevation_map.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// Whether the line from `sensor` to `point` (window frame) runs free above the map: in no cell
/// that it crosses, the point's own left out, does it dip more than the tolerance o_t below the
/// known height, where the sum of confidence over the 5×5 cells around is at least o_minc.
/// Free, too, where sensor or point lies outside the window: nothing is known of the whole line.
/// A point cannot be hidden by the cell it lies in: that cell is what it tells us about.
bool has_line_of_sight(const ElevationMap& map, const Point3f& sensor, const Point3f& point,
                       const Config& config);

}  // namespace groundgrid
