// The walk of a ray over the cells of the map, paper III-A.
#include "core/method/line_of_sight.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/map/window_cells.hpp"

namespace groundgrid {
namespace {

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
                       const RayRule& rule) {
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
    if (surface - std::min(entry_z, exit_z) > rule.tolerance_m &&
        static_cast<double>(confidence_around(map, x.cell, y.cell)) >= rule.min_confidence)
      return false;
    entry_z = exit_z;
    if (x.next <= y.next)
      x.advance();
    else
      y.advance();
  }
  return true;
}

}  // namespace groundgrid
