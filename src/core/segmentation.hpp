#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/rasterization.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Point cloud segmentation, paper III-F: a point up to h_g above the elevation of a ground cell,
/// or up to h_o above that of any other cell, is ground. Outliers keep their label.
void segment(const BinnedPoints& bins, const std::vector<std::uint8_t>& is_ground,
             const ElevationMap& map, const Config& config, TileRunner& runner,
             std::span<Label> labels, std::span<float> height_above_ground);

}  // namespace groundgrid
