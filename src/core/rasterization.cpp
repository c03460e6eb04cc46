// Point cloud rasterization, paper III-B.
#include "core/rasterization.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "core/exclusion.hpp"
#include "core/window_cells.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kBinnedPerTile = 8192;
constexpr float kStepsPerMetre = 1e4F;
// Points further above or below the z origin are outside the map: the squares of the heights of
// four million points up to 2^21 steps (209.7 m) fit into 64 bits.
constexpr float kHeightLimit_m = 209.0F;

std::uint32_t cell_of(const WindowCells& cells, const Point3f& p) {
  if (!cells.contains(p) || !(std::abs(p.z) < kHeightLimit_m)) return BinnedPoints::kNoCell;
  return static_cast<std::uint32_t>(cells.index_of(p.y) * cells.size + cells.index_of(p.x));
}

template <typename TransformOf>
void bin_range(const SensorPass& pass, std::size_t begin, std::size_t end,
               const Exclusion& exclusion, const WindowCells& cells, BinnedPoints& bins,
               const TransformOf& transform_of) {
  for (std::size_t i = begin; i < end; ++i) {
    const Point3f p = load_point(pass.points, i);
    const Point3f q = transform_of(i).apply(p);
    std::uint32_t cell = cell_of(cells, q);
    if (exclusion.takes(p, pass.T_base_sensor)) cell = BinnedPoints::kNoCell;
    bins.cell[pass.first + i] = cell;
    bins.z[pass.first + i] = cell == BinnedPoints::kNoCell
                                 ? 0
                                 : static_cast<std::int32_t>(std::lrint(q.z * kStepsPerMetre));
  }
}

void add_point(CellStatistics& cell, std::int32_t z) {
  const std::int64_t height = z;
  cell.min = cell.count == 0 ? z : std::min(cell.min, z);
  cell.max = cell.count == 0 ? z : std::max(cell.max, z);
  cell.sum += height;
  cell.sum_squares += static_cast<std::uint64_t>(height * height);
  ++cell.count;
}

void clear(ScanGrid& grid) {
  for (const std::uint32_t cell : grid.occupied) {
    grid.statistics[cell] = CellStatistics{};
    grid.is_occupied[cell] = 0;
  }
  grid.occupied.clear();
}

void list_occupied_cells(ScanGrid& grid) {
  const std::size_t cells = grid.is_occupied.size();
  std::size_t cell = 0;
  for (; cell + 8 <= cells; cell += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &grid.is_occupied[cell], sizeof(eight));
    if (eight == 0) continue;
    for (std::size_t i = cell; i < cell + 8; ++i)
      if (grid.is_occupied[i] != 0) grid.occupied.push_back(static_cast<std::uint32_t>(i));
  }
  for (; cell < cells; ++cell)
    if (grid.is_occupied[cell] != 0) grid.occupied.push_back(static_cast<std::uint32_t>(cell));
}

}  // namespace

void bin_points(const SensorPass& pass, const ElevationMap& map, const Config& config,
                TileRunner& runner, BinnedPoints& bins) {
  const Exclusion exclusion(config);
  const WindowCells cells(map);
  if (pass.trajectory.moving()) {
    runner.parallel_for_ranges(
        pass.points.count, kBinnedPerTile, [&](std::size_t begin, std::size_t end) {
          bin_range(pass, begin, end, exclusion, cells, bins,
                    [&](std::size_t i) { return pass.trajectory.at(pass.points, i); });
        });
    return;
  }
  // A copy of its own stays in registers.
  const PointTransform T_window_sensor = pass.trajectory.end();
  runner.parallel_for_ranges(
      pass.points.count, kBinnedPerTile, [&](std::size_t begin, std::size_t end) {
        bin_range(pass, begin, end, exclusion, cells, bins,
                  [&](std::size_t) -> const PointTransform& { return T_window_sensor; });
      });
}

void rasterize(const BinnedPoints& bins, std::span<const Label> labels, TileRunner& runner,
               ScanGrid& grid) {
  clear(grid);
  for_each_binned_point(bins, labels, grid.statistics.size(), runner,
                        [&](std::uint32_t cell, std::int32_t z) {
                          add_point(grid.statistics[cell], z);
                          grid.is_occupied[cell] = 1;
                        });
  list_occupied_cells(grid);
}

}  // namespace groundgrid
