#pragma once

#include <cmath>
#include <cstdint>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/rasterization.hpp"

namespace groundgrid {

/// Eq. 1: the variance below which a cell at this planar distance from the sensor is ground, m².
double variance_threshold(double distance_m, const Config& config);

/// Eq. 2: the number of points that one beam leaves in a cell at this distance on open ground.
double expected_points(double distance_m, const Config& config);

/// The slope at a cell from its own height and those of the cells before and after it along an
/// axis: the flatter of both sides, and none where the ground turns there. An obstacle beside the
/// cell makes one side steep, never both.
inline float slope_along(float before, float own, float after, float cell_size) {
  const float rise_to = own - before;
  const float rise_from = after - own;
  if (rise_to * rise_from <= 0.0F) return 0.0F;
  return (std::abs(rise_to) < std::abs(rise_from) ? rise_to : rise_from) / cell_size;
}

/// What the sums over a cell's 3×3 or 5×5 patch say; for every occupied cell.
struct GroundCell {
  float patch_points = 0.0F;     ///< ΣP.
  float patch_elevation = 0.0F;  ///< Eq. 3, metres above the z origin.
  float variance = 0.0F;         ///< The variance that was tested, m².
  bool observed = false;         ///< Enough points to be judged at all.
  bool ground = false;           ///< Classified as ground.
};

/// The planar positions of the sensors in the window frame; distances are to the nearest one.
struct SensorPositions {
  std::vector<Point3f> sensors;
  [[nodiscard]] float distance_to(float x, float y) const;
};

/// Classification of ground cells, paper III-C. The scratch and the answer, reused every scan.
class GroundCells {
 public:
  explicit GroundCells(std::size_t cells);

  void classify(const ScanGrid& grid, const ElevationMap& map, const SensorPositions& sensors,
                const Config& config, TileRunner& runner);

  /// Element i belongs to ScanGrid::occupied[i].
  [[nodiscard]] const std::vector<GroundCell>& cells() const { return cells_; }

  /// Takes back that a cell is ground: occupied cell `i`, cell `cell` of the window.
  void withdraw(std::size_t i, std::uint32_t cell) {
    cells_[i].ground = false;
    is_ground_[cell] = 0;
  }

  /// 1 for each cell of the window that is ground in this scan.
  [[nodiscard]] const std::vector<std::uint8_t>& is_ground() const { return is_ground_; }

 private:
  struct Weighted {
    float points = 0.0F;
    float min_height = 0.0F;  ///< count · minimum
    float variance = 0.0F;    ///< count · variance
    float own_variance = 0.0F;
  };
  void summarise(const ScanGrid& grid, TileRunner& runner);
  [[nodiscard]] float slope_squared(int column, int row, int size, float cell_size) const;
  [[nodiscard]] Weighted sum_patch(int column, int row, int half, int size) const;

  std::vector<Weighted> weighted_;
  std::vector<std::uint32_t> summarised_;
  std::vector<GroundCell> cells_;
  std::vector<std::uint8_t> is_ground_;
};

}  // namespace groundgrid
