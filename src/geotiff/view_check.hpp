#pragma once

#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// Throws std::invalid_argument where a view put together by hand does not hold together.
void check_view(const TerrainView& view);

}  // namespace groundgrid::geotiff
