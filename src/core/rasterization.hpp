#pragma once

#include <algorithm>
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

/// Lowest height of a cell that has points, metres above the z origin.
inline float lowest_m(const CellStatistics& cell) {
  return static_cast<float>(cell.min) * static_cast<float>(CellStatistics::kStep_m);
}

/// Transforms every point to the window frame and finds its cell and height. Points that are not
/// finite, too near, on the own vehicle or outside the window get kNoCell.
void bin_points(const SensorPass& pass, const ElevationMap& map, const Config& config,
                TileRunner& runner, BinnedPoints& bins);

/// Calls add(cell, z) for every point that has a cell and is no outlier. Each tile owns a band of
/// cells and picks its points out of all: what `add` writes to its cell needs no lock, and sums of
/// whole numbers come out the same whoever adds them in whatever order.
template <typename Add>
void for_each_binned_point(const BinnedPoints& bins, std::span<const Label> labels,
                           std::size_t cells, TileRunner& runner, const Add& add) {
  // Every band reads all points, so more of them than this would cost more than they bring.
  constexpr int kMaxBands = 8;
  const auto bands = static_cast<std::size_t>(std::min(runner.threads(), kMaxBands));
  runner.parallel_for_tiles(bands, [&](std::size_t band) {
    const auto begin = static_cast<std::uint32_t>(cells * band / bands);
    const auto length = static_cast<std::uint32_t>(cells * (band + 1) / bands) - begin;
    for (std::size_t i = 0; i < bins.cell.size(); ++i) {
      const std::uint32_t cell = bins.cell[i];
      if (cell - begin < length && labels[i] != Label::outlier) add(cell, bins.z[i]);
    }
  });
}

/// Count, sum, sum of squares, minimum and maximum per cell over all points but the outliers.
void rasterize(const BinnedPoints& bins, std::span<const Label> labels, TileRunner& runner,
               ScanGrid& grid);

}  // namespace groundgrid
