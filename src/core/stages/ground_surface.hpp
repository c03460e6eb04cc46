#pragma once

#include <span>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/stages/ground_cells.hpp"
#include "core/stages/plane_hierarchy.hpp"
#include "core/stages/rasterization.hpp"
#include "core/stages/surface_fit.hpp"
#include "groundgrid/config.hpp"

namespace groundgrid {

/// What the ground looks like on the whole, from the ground cells of this scan and those that the
/// map remembers: tells ground from what is as flat and stands on it, fills what nothing was seen
/// of, and says how far off each height may be. Not in the paper; see docs/method.md.
class GroundSurface {
 public:
  /// Its tasks run on `runner`, which outlives this object.
  GroundSurface(const ElevationMap& map, TileRunner& runner);

  /// Takes the class from ground cells, and the confidence from remembered ones, that stand on the
  /// surface and are no terrace. `ground` is the plane that the vehicle stands on, its height
  /// measured in the window.
  void withdraw_raised(const ScanGrid& grid, const LocalPlane& ground, GroundCells& ground_cells,
                       ElevationMap& map);

  /// Makes lone cells ground that lie on the surface of all others.
  void accept_lone(const ScanGrid& grid, GroundCells& ground_cells);

  /// Gives every cell that is neither ground in this scan nor remembered the height of a finer
  /// surface through those that are, and lets confidence decay where there is no ground.
  void fill(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
            const GroundCells& ground_cells, ElevationMap& map);

  /// For maps that fill() did not fill: fits the surface to the cells that are marked or have at
  /// least this confidence.
  void fit_known(const std::vector<std::uint8_t>& is_known, float min_confidence,
                 const LocalPlane& ground, const ElevationMap& map);

  /// Standard deviation of each cell's height in the map as it stands after fill() or fit_known(),
  /// metres.
  std::span<const float> standard_deviation(const ElevationMap& map);

 private:
  void collect(const ScanGrid& grid, const GroundCells& ground_cells, const ElevationMap& map);

  void follow_lowest(const ScanGrid& grid, const std::vector<std::uint8_t>& is_ground,
                     ElevationMap& map);

  TileRunner* runner_;
  SurfaceFit fit_;
  std::vector<float> deviation_;  // per cell
};

}  // namespace groundgrid
