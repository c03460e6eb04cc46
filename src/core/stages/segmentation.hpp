#pragma once

#include <span>

#include "core/kernels/point_kernels.hpp"
#include "core/parallel.hpp"
#include "core/stages/cell_limits.hpp"
#include "core/stages/rasterization.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Point cloud segmentation, paper III-F: a point up to its cell's threshold above its cell's
/// level is ground, a higher one an obstacle. Outliers are measured from the map: they do not make
/// their cell an occupied one, so it may have no limit. Returns how many points got each label.
LabelCounts segment(const BinnedPoints& bins, const CellLimits& limits, const ElevationMap& map,
                    const Config& config, TileRunner& runner, std::span<Label> labels,
                    std::span<float> height_above_ground);

}  // namespace groundgrid
