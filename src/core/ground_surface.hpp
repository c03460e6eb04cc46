#pragma once

#include <cstdint>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/ground_cells.hpp"
#include "core/plane_hierarchy.hpp"
#include "core/rasterization.hpp"
#include "groundgrid/config.hpp"

namespace groundgrid {

/// What the ground looks like on the whole, from the ground cells of this scan and those that the
/// map remembers: tells ground from what is as flat and stands on it, and fills what nothing was
/// seen of. Not in the paper; see docs/method.md.
class GroundSurface {
 public:
  explicit GroundSurface(const ElevationMap& map);

  /// Fits planes again and again with less weight for the cells above them, then takes the class
  /// from ground cells, and the confidence from remembered ones, that still stand
  /// surface_step_m above and are no plateau. `ground` is the plane that the vehicle stands on,
  /// its height measured in the window.
  void reject_raised(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
                     GroundCells& ground_cells, ElevationMap& map);

  /// Gives every cell that is neither ground in this scan nor remembered the height of a finer
  /// surface through those that are, and lets confidence decay where there is no ground.
  void fill(const ScanGrid& grid, const LocalPlane& ground, const Config& config,
            const GroundCells& ground_cells, ElevationMap& map);

 private:
  enum class Standing : std::uint8_t { unknown, on_surface, raised, judged };

  void collect(const ScanGrid& grid, const GroundCells& ground_cells, const ElevationMap& map,
               const Config& config);
  void reweight(const Config& config);
  void find_raised(const Config& config);
  void keep_plateaus(const Config& config);
  void follow_raised(std::uint32_t seed);

  int size_;
  float cell_size_;
  PlaneHierarchy planes_;
  std::vector<float> weights_;        // per cell; 0 where nothing is known
  std::vector<float> heights_;        // per cell, where it has a weight
  std::vector<float> surface_;        // per cell
  std::vector<Standing> standing_;    // per cell
  std::vector<std::uint32_t> known_;  // cells with a weight, ascending
  std::vector<std::uint32_t> patch_;  // of raised cells, in the order they were found
};

}  // namespace groundgrid
