#pragma once

#include "core/elevation_map.hpp"
#include "core/ground_cells.hpp"
#include "core/parallel.hpp"

namespace groundgrid {

/// Height and confidence of one cell of the map.
struct CellEstimate {
  float height = 0.0F;
  float confidence = 0.0F;
};

/// Eq. 4: confidence of one scan's elevation from the number of points in the patch, 0 to 1.
float observation_confidence(float patch_points, const Config& config);

/// Eq. 5 and 6: the known estimate after a scan that shows ground in the cell.
CellEstimate fuse_ground(const CellEstimate& known, float elevation, float confidence);

/// End of III-D: the known estimate after a scan that shows something else in the cell, which
/// lowers the ground where it stands below it.
CellEstimate fuse_obstacle(const CellEstimate& known, float elevation);

/// Ground elevation and confidence, paper III-D: takes this scan's cells into the map.
void update_elevation(const ScanGrid& grid, const GroundCells& ground_cells, const Config& config,
                      TileRunner& runner, ElevationMap& map);

}  // namespace groundgrid
