#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernels/ground_cell_kernels.hpp"
#include "core/map/elevation_map.hpp"
#include "core/method/constants.hpp"
#include "core/parallel.hpp"
#include "core/stages/rasterization.hpp"

namespace groundgrid {

/// The slope at a cell from its own height and those of the cells before and after it along an
/// axis: the flatter of both sides, and none where the ground turns there. An obstacle beside the
/// cell makes one side steep, never both.
inline float slope_along(float before, float own, float after, float cell_size) {
  const float rise_to = own - before;
  const float rise_from = after - own;
  if (rise_to * rise_from <= 0.0F) return 0.0F;
  return (std::abs(rise_to) < std::abs(rise_from) ? rise_to : rise_from) / cell_size;
}

/// What a slope adds to the variance of a cell, over its square: points spread evenly over a width
/// w that rises by s · w have a variance of (s · w)² / 12.
inline float variance_per_slope(float cell_size) { return cell_size * cell_size / 12.0F; }

/// The variance in m² below which a cell is ground, on ground of this slope squared.
inline float variance_threshold_on(float slope_squared, float cell_size) {
  constexpr auto kMostSquared = static_cast<float>(constants::kSteepest * constants::kSteepest);
  return constants::kMaxVariance_m2 +
         std::min(slope_squared, kMostSquared) * variance_per_slope(cell_size);
}
inline float steepest_threshold(float cell_size) { return variance_threshold_on(1e9F, cell_size); }

/// Classification of ground cells in place of paper III-C: one threshold for their variance at any
/// distance and number of points. The scratch and the answer, reused every scan.
class GroundCells {
 public:
  explicit GroundCells(std::size_t cells);

  /// `supported` is 1 for each cell of the window that may be ground, see CellSupport; `sensors`
  /// are their places in the window frame.
  void classify(const ScanGrid& grid, const ElevationMap& map,
                const std::vector<std::uint8_t>& supported, std::span<const Point3f> sensors,
                TileRunner& runner);

  /// Element i belongs to ScanGrid::occupied[i].
  [[nodiscard]] const std::vector<GroundCell>& cells() const { return cells_; }

  /// Takes back that a cell is ground: occupied cell `i`, cell `cell` of the window.
  void withdraw(std::size_t i, std::uint32_t cell) {
    cells_[i].ground = false;
    is_ground_[cell] = 0;
  }

  /// Makes a lone cell ground.
  void accept(std::size_t i, std::uint32_t cell) {
    cells_[i].ground = cells_[i].observed = true;
    is_ground_[cell] = 1;
  }

  /// 1 for each cell of the window that is ground in this scan.
  [[nodiscard]] const std::vector<std::uint8_t>& is_ground() const { return is_ground_; }

 private:
  void summarise(const ScanGrid& grid, TileRunner& runner);

  std::vector<WeightedCell> weighted_;
  std::vector<std::uint32_t> summarised_;
  std::vector<GroundCell> cells_;
  std::vector<std::uint8_t> is_ground_;
};

}  // namespace groundgrid
