#pragma once

#include <cstdint>
#include <vector>

#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// Points are counted over the square of an odd number of cells around a cell whose side comes
/// nearest to a metre: 3 × 3 cells of 0.33 m. It reaches so many cells to each side.
int density_reach(double resolution_m);

/// Area of that square, m².
double density_area_m2(double resolution_m);

/// Points of the view's scan in the square around each cell, in the order of the view's cells.
/// Cells beyond the view have none; a sum stays at its greatest value once there.
void count_points_around(const TerrainView& view, std::vector<std::uint32_t>& points_around);

}  // namespace groundgrid::geotiff
