#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/point_kernels.hpp"
#include "core/rasterization.hpp"
#include "groundgrid/label.hpp"

/// The method of the paper, to the letter: section III, a function for each step, in its order.
namespace groundgrid::paper {

/// One scan in the window of the map.
struct Scan {
  std::span<const SensorPass> sensors;  ///< Points as they were measured.
  std::span<const Point3f> positions;   ///< Of the sensors.
};

/// One element a point.
struct Answers {
  std::span<Label> labels;
  std::span<float> height_above_ground;
};

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

/// All of it for a scan whose points have their cells and heights in `bins`. `grid` and
/// `is_ground` are buffers, and tell afterwards what was seen.
LabelCounts process(const Scan& scan, const Config& config, BinnedPoints& bins, ScanGrid& grid,
                    GroundMask& is_ground, ElevationMap& map, const Answers& answers);

}  // namespace groundgrid::paper
