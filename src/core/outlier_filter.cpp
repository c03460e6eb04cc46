// Outlier filtering by line of sight, paper III-A.
#include "core/outlier_filter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/point_kernels.hpp"
#include "core/window_cells.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kFilteredAtOnce = 2048;

/// Walks along one axis of the grid: where the ray enters the next cell, in shares of its length.
struct AxisWalk {
  int cell;
  int last;
  int step;
  double next;
  double per_cell;

  AxisWalk(const WindowCells& cells, float from_m, float to_m) {
    const auto from = static_cast<double>(cells.in_cells(from_m));
    const auto to = static_cast<double>(cells.in_cells(to_m));
    cell = cells.index_of(from_m);
    last = cells.index_of(to_m);
    step = to > from ? 1 : -1;
    const double length = std::abs(to - from);
    const double border = cell + (step > 0 ? 1 : 0);
    next =
        cell == last ? std::numeric_limits<double>::infinity() : std::abs(border - from) / length;
    per_cell = 1.0 / length;
  }

  void advance() {
    cell += step;
    next = cell == last ? std::numeric_limits<double>::infinity() : next + per_cell;
  }
};

float confidence_around(const ElevationMap& map, int column, int row) {
  float sum = 0.0F;
  for (int y = std::max(row - 2, 0); y <= std::min(row + 2, map.size() - 1); ++y)
    for (int x = std::max(column - 2, 0); x <= std::min(column + 2, map.size() - 1); ++x)
      sum += map.confidence()[static_cast<std::size_t>(y * map.size() + x)];
  return sum;
}

}  // namespace

bool has_line_of_sight(const ElevationMap& map, const Point3f& sensor, const Point3f& point,
                       const Config& config) {
  const WindowCells cells(map);
  if (!cells.contains(sensor) || !cells.contains(point)) return true;
  AxisWalk x(cells, sensor.x, point.x);
  AxisWalk y(cells, sensor.y, point.y);
  const double z_begin = static_cast<double>(sensor.z);
  const double drop = static_cast<double>(point.z) - z_begin;
  double entry_z = z_begin;
  while (x.cell != x.last || y.cell != y.last) {
    const double leave = std::min(x.next, y.next);
    const double exit_z = z_begin + std::min(leave, 1.0) * drop;
    const auto surface =
        static_cast<double>(map.height()[static_cast<std::size_t>(y.cell * map.size() + x.cell)]);
    // The confidence comes last: few rays ever dip below the surface.
    if (surface - std::min(entry_z, exit_z) > config.outlier_tolerance_m &&
        static_cast<double>(confidence_around(map, x.cell, y.cell)) >=
            config.outlier_min_confidence)
      return false;
    entry_z = exit_z;
    if (x.next <= y.next)
      x.advance();
    else
      y.advance();
  }
  return true;
}

void filter_outliers(const SensorPass& pass, const PointRange& range, const ElevationMap& map,
                     const Config& config, BinnedPoints& bins) {
  if (map.blank()) return;
  const DepthRule rule{map.height().data(), static_cast<float>(config.outlier_min_depth_m)};
  std::uint32_t deep[kFilteredAtOnce + kSpareIndices];
  for (std::size_t begin = range.begin; begin < range.end; begin += kFilteredAtOnce) {
    const std::size_t count = std::min(kFilteredAtOnce, range.end - begin);
    std::uint32_t* cells = bins.cell.data() + pass.first + begin;
    const std::size_t found =
        find_deep({cells, bins.z.data() + pass.first + begin, count}, rule, deep);
    for (std::size_t k = 0; k < found; ++k) {
      const std::size_t i = begin + deep[k];
      const PointTransform T_window_sensor = pass.trajectory.at(pass.points, i);
      const Point3f point = T_window_sensor.apply(load_point(pass.points, i));
      if (!has_line_of_sight(map, T_window_sensor.origin(), point, config))
        cells[deep[k]] |= BinnedPoints::kOutlier;
    }
  }
}

}  // namespace groundgrid
