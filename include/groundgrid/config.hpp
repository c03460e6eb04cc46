#pragma once

#include <cstdint>
#include <optional>

#include "groundgrid/export.hpp"

namespace groundgrid {

/// How the stages of a scan are computed.
enum class Method : std::uint8_t { standard, paper, reference };

/// Every value the method depends on. `Config{}` is what works best on the real scans we can
/// measure; `Config::paper()` follows the paper to the letter. docs/method.md explains each
/// deviation of the default, groundgrid/parameters.hpp lists unit, range and paper symbol.
struct GROUNDGRID_EXPORT Config {
  // Method
  /// standard: ours, which grew out of the paper's; paper: the paper's to the letter; reference:
  /// the standard one as plain code, slowly and with the same bits.
  Method method = Method::standard;

  // Map
  /// Side of the square map around the vehicle. (m)
  double map_extent_m = 120.0;
  /// Side of a cell. (paper: R, m)
  double cell_size_m = 0.33;
  /// Map frame x of a cell's centre; the first pose's where left out. (m)
  std::optional<double> grid_anchor_x_m{};
  /// Map frame y of a cell's centre; the first pose's where left out. (m)
  std::optional<double> grid_anchor_y_m{};
  /// A move between two scans by more than this starts the map anew. (m)
  double pose_jump_m = 20.0;

  // Vehicle and sensor
  /// Height of the (first) sensor above the ground; estimated where left out and the scan brings
  /// no mounting. (m)
  std::optional<double> sensor_height_m{};
  /// Points nearer to their sensor are unknown and never enter the map. (m)
  double min_range_m = 0.0;
  /// Rear of the own vehicle's box in base; an empty box takes no point. (m)
  double own_vehicle_min_x_m = 0.0;
  /// Front of the own vehicle's box in base. (m)
  double own_vehicle_max_x_m = 0.0;
  /// Right side of the own vehicle's box in base. (m)
  double own_vehicle_min_y_m = 0.0;
  /// Left side of the own vehicle's box in base. (m)
  double own_vehicle_max_y_m = 0.0;
  /// Bottom of the own vehicle's box in base. (m)
  double own_vehicle_min_z_m = 0.0;
  /// Top of the own vehicle's box in base. (m)
  double own_vehicle_max_z_m = 0.0;

  // Outlier filter (III-A)
  /// A ray may dip this far below the map and still be free. (paper: o_t, m)
  double outlier_tolerance_m = 0.1;
  /// Sum of confidence over 5x5 cells that a cell needs to block a ray. (paper: o_minc)
  double outlier_min_confidence = 8.0;
  /// Only points at least this far below the map are tested; -1000000 tests all. (m)
  double outlier_min_depth_m = 0.3;

  // Ground cells (III-C)
  /// Variance threshold per metre of distance (eq. 1). (paper: d_sf, m)
  double variance_distance_factor = 5e-5;
  /// Least variance threshold. (paper: t_minv, m²)
  double min_variance_threshold = 5e-4;
  /// Angle between neighbouring points of a beam (eq. 2). (paper: d_pv, deg)
  double point_angle_deg = 0.4;
  /// Share of the expected points that a cell needs. (paper: g_minp)
  double min_point_fraction = 0.25;
  /// Patches are 3x3 nearer than this, 5x5 beyond. (paper: d_ps, m)
  double patch_change_distance_m = 40.0;
  /// From this count on a cell's own variance is used. (paper: v_np)
  int own_variance_min_points = 5;
  /// Steepest ground whose rise within a cell does not count as variance, m/m; 0: all does.
  double max_cell_slope = 0.7;
  /// Cells whose lowest returns do not form a surface of this many are not ground; 0: all may be.
  int min_support_cells = 25;

  // Ground surface (not in the paper)
  /// Least side of the blocks of planes that tell which cells rise. (m)
  double surface_block_m = 4.5;
  /// Cells more than this above the surface lose weight in the fit. (m)
  double surface_tolerance_m = 0.06;
  /// Cells more than this above the surface are no ground. (m)
  double surface_step_m = 0.2;
  /// Wider patches of such cells are ground all the same: terraces, banks. (m²)
  double plateau_area_m2 = 5.0;
  /// Unless they stand more than this above the surface on average. (m)
  double plateau_height_m = 1.0;
  /// Cells of at least this confidence are remembered as ground.
  double surface_min_confidence = 0.05;
  /// A cell without ground whose lowest return is less than this above the surface takes that
  /// return's height. (m)
  double surface_follow_m = 0.1;

  // Elevation and confidence (III-D)
  /// Points in a patch for full confidence (eq. 4). (paper: s)
  double confidence_point_scale = 20.0;

  // Interpolation (III-E)
  /// Decay of confidence where a scan shows no ground (eq. 8). (paper: θ)
  double confidence_decay = 5.0;

  // Segmentation (III-F)
  /// Greatest height of a ground point in a ground cell (paper) or where nothing rises from the
  /// ground (ours). (paper: h_g, m)
  double ground_threshold_m = 0.2;
  /// Greatest height of a ground point in any other cell; of the paper's method. (paper: h_o, m)
  double obstacle_threshold_m = 0.1;
  /// Returns higher than this above the map rise from the ground. (m)
  double tall_height_m = 0.3;
  /// Returns higher than this above the map, with none below them, hang over the ground. (m)
  double overhang_height_m = 1.0;
  /// Something rises only where there are more such returns than this share of the ground's.
  double tall_min_share = 0.15;
  /// Greatest height of a ground point where something rises from the ground. (m)
  double tall_threshold_m = 0.06;
  /// Points up to this far above the map make the mean that heights are measured from. (m)
  double level_band_m = 0.15;
  /// Steps of the ground higher than this, such as kerbs, are obstacles; 0: none is. (m)
  double max_step_m = 0.0;

  // Execution
  /// Threads to use; 0 for one per core.
  int threads = 1;

  /// The paper's equations and its parameter section, to the letter.
  static Config paper();

  /// Throws std::invalid_argument that names the field, its value and the range allowed.
  void validate() const;
};

}  // namespace groundgrid
