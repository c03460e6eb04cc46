#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/point_transform.hpp"
#include "groundgrid/label.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid {

/// Where the points of a scan fell: per point its cell and its height.
struct BinnedPoints {
  static constexpr std::uint32_t kNoCell = 0xFFFFFFFFU;

  std::vector<std::uint32_t> cell;  ///< Cell of the window; kNoCell for points without an answer.
  std::vector<std::int32_t> z;      ///< Height above the z origin in steps of 0.1 mm.

  void resize(std::size_t points) {
    cell.resize(points);
    z.resize(points);
  }
};

/// One sensor's share of a scan, ready to be transformed.
struct SensorPass {
  PointView points;
  std::size_t first = 0;  ///< Index of the sensor's first point among all sensors' points.
  SensorTrajectory trajectory;
  PointTransform T_base_sensor;
};

/// Per-cell data of the current scan (paper III-B).
struct ScanGrid {
  std::vector<CellStatistics> statistics;  ///< One a cell; count 0 where nothing fell.
  std::vector<std::uint8_t> is_occupied;   ///< 1 where count > 0.
  std::vector<std::uint32_t> occupied;     ///< Cells with points, ascending.

  explicit ScanGrid(std::size_t cells) : statistics(cells), is_occupied(cells) {
    occupied.reserve(cells);
  }
};

/// Transforms every point to the window frame and finds its cell and height. Points that are not
/// finite, too near, on the own vehicle or outside the window get kNoCell.
void bin_points(const SensorPass& pass, const ElevationMap& map, const Config& config,
                TileRunner& runner, BinnedPoints& bins);

/// Count, sum, sum of squares, minimum and maximum per cell over all points but the outliers.
void rasterize(const BinnedPoints& bins, std::span<const Label> labels, TileRunner& runner,
               ScanGrid& grid);

}  // namespace groundgrid
