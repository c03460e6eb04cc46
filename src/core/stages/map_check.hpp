#pragma once

#include "core/map/elevation_map.hpp"
#include "core/stages/rasterization.hpp"

namespace groundgrid {

/// Whether a scan shows that the ground is not where the map has it: after a lift, or with a pose
/// that is wrong in z. Of the cells that the map knows well and that this scan sees as flat, most
/// then lie above the map, or most below it. If few such cells are left, many points that
/// the map has made outliers say so as well.
bool contradicts_map(const BinnedPoints& bins, const ScanGrid& grid, const ElevationMap& map);

}  // namespace groundgrid
