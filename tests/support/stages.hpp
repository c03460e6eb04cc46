#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/method/paper_method.hpp"
#include "core/parallel.hpp"
#include "core/stages/rasterization.hpp"
#include "groundgrid/config.hpp"

namespace groundgrid::testing {

/// The paper's values on a map of `cells` × `cells`
/// cells of one metre; `cells` is odd.
inline Config metre_grid(int cells) {
  Config config = Config::paper();
  config.map.resolution_m = 1.0;
  config.map.extent_m = cells - 1;
  return config;
}

/// A map whose window's corner is the origin of the map frame and whose heights are 0.
inline ElevationMap flat_map(const Config& config) {
  ElevationMap map(config);
  const double centre = 0.5 * map.size() * map.cell_size();
  map.start({centre, centre, 0.0, 0.0, 0.0});
  return map;
}

inline std::size_t cell_index(const ElevationMap& map, int column, int row) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(map.size()) +
         static_cast<std::size_t>(column);
}

/// Points by cell and height, and the grid made from them.
class PointsInCells {
 public:
  explicit PointsInCells(const ElevationMap& map) : map_(map), grid_(map.cells()) {}

  void add(int column, int row, std::initializer_list<double> heights_m) {
    for (const double height : heights_m) {
      bins_.cell.push_back(static_cast<std::uint32_t>(cell_index(map_, column, row)));
      bins_.z.push_back(static_cast<std::int32_t>(std::lround(height / CellStatistics::kStep_m)));
    }
  }

  const BinnedPoints& bins() const { return bins_; }

  const ScanGrid& grid() {
    paper::rasterize(bins_, grid_);
    return grid_;
  }

 private:
  const ElevationMap& map_;
  BinnedPoints bins_;
  ScanGrid grid_;
};

}  // namespace groundgrid::testing
