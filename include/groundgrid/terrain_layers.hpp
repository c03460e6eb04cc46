#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "groundgrid/export.hpp"
#include "groundgrid/label.hpp"
#include "groundgrid/scan.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid {

/// Whether a vehicle can drive over a cell.
enum class Traversability : std::uint8_t { unknown, no, yes };

/// Up to where a vehicle drives; the defaults are those of a car. docs/terrain-layers.md says
/// where they come from.
struct GROUNDGRID_EXPORT TraversabilityLimits {
  double max_slope_deg = 20.0;         ///< Steepest slope.
  double max_step_m = 0.1;             ///< Highest step.
  double max_roughness_m = 0.05;       ///< Greatest roughness.
  double min_obstacle_height_m = 0.2;  ///< Lower returns above the ground are no obstacle.
  double overhang_clearance_m = 2.5;   ///< Higher returns above the ground are driven under.
  double min_confidence = 0.05;        ///< Cells of the map with less are not known.

  /// Throws std::invalid_argument that names the field if one is negative or not finite.
  void validate() const;
};

/// What the layers say of one cell; NaN is what is not known.
struct CellLayers {
  float slope_deg;
  float step_m;
  float roughness_m;
  float obstacle_height_m;
};

/// `no` if an obstacle stands or a limit is passed; else `yes` if slope, step and roughness are
/// known, and `unknown` if they are not.
GROUNDGRID_EXPORT Traversability traversability_of(const CellLayers& cell,
                                                   const TraversabilityLimits& limits);

/// What planners ask of the map beyond its height: slope, step, roughness, obstacles, and whether
/// a cell can be driven over. One element a cell, row by row, x fastest, as in the TerrainView.
/// Optional and apart from GroundGrid::process(), which costs no more for it.
///
/// A cell is known if its confidence reaches TraversabilityLimits::min_confidence; only known
/// cells count in any layer of the ground, and only they have one.
class GROUNDGRID_EXPORT TerrainLayers {
 public:
  /// Planes are fitted to squares of an odd number of cells, whose side is nearest to `window_m`
  /// and at least three cells. Throws std::invalid_argument if it is not in (0, 100] m.
  explicit TerrainLayers(double window_m = 1.0);
  ~TerrainLayers();
  TerrainLayers(TerrainLayers&&) noexcept;
  TerrainLayers& operator=(TerrainLayers&&) noexcept;
  TerrainLayers(const TerrainLayers&) = delete;
  TerrainLayers& operator=(const TerrainLayers&) = delete;

  /// Makes all layers anew. Allocates only if the map has more cells than any before. Obstacles
  /// are those of the last scan as TerrainView::statistics has them: of a cell with returns both
  /// below and above the clearance, such as a road under a tree, its obstacle height is NaN, since
  /// only the other update() knows the points. Throws std::invalid_argument if a limit is wrong
  /// or a layer of the view has not size × size cells.
  void update(const TerrainView& terrain, const TraversabilityLimits& limits = {});

  /// The same with the points of the last scan and what GroundGrid::process() said of them, in its
  /// order; outliers and unknown points are no obstacles. Points are taken at the one pose. Throws
  /// also if there is not one label a point or a point view has no data.
  void update(const TerrainView& terrain, std::span<const SensorScan> scans,
              const Eigen::Isometry3d& T_map_base, std::span<const Label> labels,
              const TraversabilityLimits& limits = {});

  /// Cells along x and along y; 0 before the first update.
  [[nodiscard]] int size() const;
  /// Angle of the plane through the window to the horizontal, degrees; NaN if less than half of
  /// the window is known.
  [[nodiscard]] std::span<const float> slope_deg() const;
  /// Greatest rise from one neighbour to the opposite one, along x, y or a diagonal, beyond the
  /// slope of the ground on both sides, metres; NaN if no two opposite neighbours are known.
  [[nodiscard]] std::span<const float> step_m() const;
  /// Root mean square of the window's heights from its plane, metres; NaN as the slope.
  [[nodiscard]] std::span<const float> roughness_m() const;
  /// Height above the map of the highest return of the last scan below the clearance, metres; 0
  /// where it is lower than min_obstacle_height_m, NaN where none was below the clearance.
  [[nodiscard]] std::span<const float> obstacle_height_m() const;
  /// As traversability_of() of each cell.
  [[nodiscard]] std::span<const Traversability> traversability() const;

 private:
  class GROUNDGRID_NO_EXPORT Layers;
  std::unique_ptr<Layers> layers_;
};

}  // namespace groundgrid
