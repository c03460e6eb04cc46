#include "geotiff/point_density.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "core/map/cell_statistics.hpp"
#include "geotiff/saturating_sum.hpp"

namespace groundgrid::geotiff {
namespace {

constexpr double kSide_m = 1.0;
// Far more than a cell that a map is made of can need; keeps the number within an int.
constexpr double kFarthestReach = 1e6;

}  // namespace

int density_reach(double resolution_m) {
  const double reach = std::round((kSide_m / resolution_m - 1.0) / 2.0);
  return static_cast<int>(std::clamp(reach, 0.0, kFarthestReach));
}

double density_area_m2(double resolution_m) {
  const double side_m = (2 * density_reach(resolution_m) + 1) * resolution_m;
  return side_m * side_m;
}

void count_points_around(const TerrainView& view, std::vector<std::uint32_t>& points_around) {
  points_around.assign(statistics_of(view).size(), 0);
  const int reach = density_reach(view.resolution_m);
  const auto index = [&](int column, int row) {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(view.size) +
           static_cast<std::size_t>(column);
  };
  // A scan reaches few of the cells, so those with points give to their neighbours.
  for (int row = 0; row < view.size; ++row) {
    for (int column = 0; column < view.size; ++column) {
      const std::uint32_t count = view.statistics[index(column, row)].count;
      if (count == 0) continue;
      for (int y = std::max(row - reach, 0); y <= std::min(row + reach, view.size - 1); ++y)
        for (int x = std::max(column - reach, 0); x <= std::min(column + reach, view.size - 1); ++x)
          points_around[index(x, y)] = saturating_sum(points_around[index(x, y)], count);
    }
  }
}

}  // namespace groundgrid::geotiff
