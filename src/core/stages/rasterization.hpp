#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/exclusion.hpp"
#include "core/kernels/point_kernels.hpp"
#include "core/map/cell_statistics.hpp"
#include "core/map/elevation_map.hpp"
#include "core/map/window_cells.hpp"
#include "core/parallel.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// Where the points of a scan fell: per point its cell and its height.
struct BinnedPoints {
  static constexpr std::uint32_t kNoCell = 0xFFFFFFFFU;
  /// Added to the cell of an outlier, which no stage but the last takes then.
  static constexpr std::uint32_t kOutlier = 0x80000000U;
  static constexpr float kStepsPerMetre = 1e4F;

  std::vector<std::uint32_t> cell;  ///< Cell of the window; kNoCell for points without an answer.
  std::vector<std::int32_t> z;      ///< Height above the z origin in steps of 0.1 mm.

  void resize(std::size_t points) {
    cell.resize(points);
    z.resize(points);
  }
  [[nodiscard]] bool is_outlier(std::size_t point) const {
    return cell[point] >= kOutlier && cell[point] != kNoCell;
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

/// A length in the steps of heights.
inline std::int32_t in_steps(double metres) {
  return static_cast<std::int32_t>(std::lrint(metres / CellStatistics::kStep_m));
}
/// A height of the map in steps. What leaves 32 bits is cut off: no point is that far from the z
/// origin.
inline std::int32_t limited_steps(float metres) {
  constexpr float kMost = 1e9F;
  return static_cast<std::int32_t>(
      std::lrint(std::clamp(metres * BinnedPoints::kStepsPerMetre, -kMost, kMost)));
}

/// Adds a point to the moments of its cell.
inline void add_point(std::int32_t z, CellStatistics& cell) {
  const std::int64_t height = z;
  cell.sum += height;
  cell.sum_squares += static_cast<std::uint64_t>(height * height);
  cell.min = std::min(cell.min, z);
  cell.max = std::max(cell.max, z);
  ++cell.count;
}

/// Points [begin, end) of one sensor.
struct PointRange {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Transforms points of a sensor to the window frame and finds their cells and heights, written
/// from pass.first on. Points that are not finite, too near, on the own vehicle or outside the
/// window get kNoCell.
void bin_points(const SensorPass& pass, const PointRange& range, const WindowCells& window,
                const Exclusion& exclusion, BinnedPoints& bins);
void bin_points(const SensorPass& pass, const PointRange& range, const ElevationMap& map,
                const Config& config, BinnedPoints& bins);

/// All points of all sensors.
void bin_points(std::span<const SensorPass> sensors, const ElevationMap& map, const Config& config,
                BinnedPoints& bins);

// Every band reads all points, so more of them than this would cost more than they bring.
constexpr std::size_t kMaxBands = 8;
inline std::size_t band_count(const TileRunner& runner) {
  return std::min(static_cast<std::size_t>(runner.threads()), kMaxBands);
}

/// Calls task(band, its number) for bands that cover all cells. Each reads all points.
template <typename Task>
void for_each_band(std::size_t cells, TileRunner& runner, const Task& task) {
  const std::size_t bands = band_count(runner);
  runner.parallel_for_tiles(bands, [&](std::size_t band) {
    task(CellBand{static_cast<std::uint32_t>(cells * band / bands),
                  static_cast<std::uint32_t>(cells * (band + 1) / bands)},
         band);
  });
}

/// Those of some ascending cells that lie in a band.
inline std::span<const std::uint32_t> cells_in(std::span<const std::uint32_t> cells,
                                               const CellBand& band) {
  const auto begin = std::lower_bound(cells.begin(), cells.end(), band.begin);
  return {begin, std::lower_bound(begin, cells.end(), band.end)};
}

/// Calls add(cell, z) for every point that has a cell and is no outlier.
template <typename Add>
void for_each_binned_point(const BinnedPoints& bins, std::size_t cells, TileRunner& runner,
                           const Add& add) {
  for_each_band(cells, runner, [&](const CellBand& band, std::size_t) {
    for (std::size_t i = 0; i < bins.cell.size(); ++i)
      if (bins.cell[i] - band.begin < band.end - band.begin) add(bins.cell[i], bins.z[i]);
  });
}

/// Count, sum, sum of squares, minimum and maximum per cell over all points but the outliers, in
/// three steps: forget the scan before, add points of a band of cells, list the occupied cells.
void clear(ScanGrid& grid);
void add_to_cells(const BinnedPoints& bins, const PointRange& range, const CellBand& band,
                  ScanGrid& grid);
void list_occupied(ScanGrid& grid);

}  // namespace groundgrid
