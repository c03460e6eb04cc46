#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/method/method.hpp"
#include "core/parallel.hpp"
#include "core/stages/cell_limits.hpp"
#include "core/stages/cell_support.hpp"
#include "core/stages/ground_cells.hpp"
#include "core/stages/ground_surface.hpp"
#include "core/stages/step_edges.hpp"

namespace groundgrid {

/// The default method, fast: the stages of reference_method.cpp in vectors and on threads, with the
/// buffers that they reuse from scan to scan. Same bits as there.
class StandardMethod {
 public:
  /// Its tasks run on `runner`, which outlives this object.
  StandardMethod(const ElevationMap& map, TileRunner& runner);

  /// Labels a scan and takes it into the map. `bins` and `grid` are buffers; `grid` tells
  /// afterwards what was seen. Nothing, with the map untouched, if the scan contradicts the map.
  std::optional<LabelCounts> process(const Scan& scan, const Config& config, BinnedPoints& bins,
                                     ScanGrid& grid, ElevationMap& map, const Answers& answers);

  /// Standard deviation of each cell's height in the map as process() left it, metres.
  std::span<const float> standard_deviation(const ElevationMap& map) {
    return surface_.standard_deviation(map);
  }
  /// The same for a map that another method filled: from the heights of the cells that are marked
  /// here or have at least this confidence.
  std::span<const float> standard_deviation(const std::vector<std::uint8_t>& is_known,
                                            float min_confidence, const LocalPlane& ground,
                                            const ElevationMap& map) {
    surface_.fit_known(is_known, min_confidence, ground, map);
    return surface_.standard_deviation(map);
  }

 private:
  void rasterize(const Scan& scan, const Config& config, const ElevationMap& map,
                 BinnedPoints& bins, ScanGrid& grid);

  TileRunner* runner_;
  CellSupport support_;
  GroundCells ground_cells_;
  GroundSurface surface_;
  CellLimits limits_;
  StepEdges step_edges_;
};

}  // namespace groundgrid
