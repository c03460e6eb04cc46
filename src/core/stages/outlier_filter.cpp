// Outlier filtering by line of sight, paper III-A, of points deep below the map alone.
#include "core/stages/outlier_filter.hpp"

#include <algorithm>

#include "core/kernels/point_kernels.hpp"
#include "core/method/constants.hpp"
#include "core/method/line_of_sight.hpp"

namespace groundgrid {
namespace {

constexpr std::size_t kFilteredAtOnce = 2048;

}  // namespace

void filter_outliers(const SensorPass& pass, const PointRange& range, const ElevationMap& map,
                     BinnedPoints& bins) {
  if (map.blank()) return;
  const DepthRule rule{map.height().data(), static_cast<float>(constants::kReflectionDepth_m)};
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
      if (!has_line_of_sight(map, T_window_sensor.origin(), point,
                             {constants::kRayTolerance_m, constants::kRayConfidence}))
        cells[deep[k]] |= BinnedPoints::kOutlier;
    }
  }
}

}  // namespace groundgrid
