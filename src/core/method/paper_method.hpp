#pragma once

#include <cstdint>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/method/method.hpp"

/// The method of the paper, to the letter: section III, a function for each step, in its order.
namespace groundgrid::paper {

/// 1 for each cell of the window that is ground in this scan.
using GroundMask = std::vector<std::uint8_t>;

/// III-A: marks points without a line of sight as outliers.
void filter_outliers(const Scan& scan, const Config& config, const ElevationMap& map,
                     BinnedPoints& bins);
/// III-B: statistics of the remaining points, cell by cell.
void rasterize(const BinnedPoints& bins, ScanGrid& grid);
/// III-C and III-D: finds the ground cells and takes their elevation into the map.
void observe_ground(const Scan& scan, const ScanGrid& grid, const Config& config,
                    GroundMask& is_ground, ElevationMap& map);
/// III-E: interpolates all other cells.
void interpolate_terrain(const Scan& scan, const GroundMask& is_ground, const Config& config,
                         ElevationMap& map);
/// III-F: labels the points.
LabelCounts segment(const BinnedPoints& bins, const GroundMask& is_ground, const ElevationMap& map,
                    const Config& config, const Answers& answers);

/// All of it. `bins`, `grid` and `is_ground` are buffers, and tell afterwards what was seen.
LabelCounts process(const Scan& scan, const Config& config, BinnedPoints& bins, ScanGrid& grid,
                    GroundMask& is_ground, ElevationMap& map, const Answers& answers);

}  // namespace groundgrid::paper
