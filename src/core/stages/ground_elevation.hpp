#pragma once

#include "core/map/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/stages/ground_cells.hpp"

namespace groundgrid {

/// Ground elevation and confidence, paper III-D: takes this scan's cells into the map.
void update_elevation(const ScanGrid& grid, const GroundCells& ground_cells, const Config& config,
                      TileRunner& runner, ElevationMap& map);

}  // namespace groundgrid
