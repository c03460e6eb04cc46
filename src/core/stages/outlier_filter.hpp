#pragma once

#include "core/map/elevation_map.hpp"
#include "core/stages/rasterization.hpp"

namespace groundgrid {

/// Marks points of one sensor that it cannot have seen with BinnedPoints::kOutlier (paper III-A).
/// The map is the one known before this scan.
void filter_outliers(const SensorPass& pass, const PointRange& range, const ElevationMap& map,
                     BinnedPoints& bins);

}  // namespace groundgrid
