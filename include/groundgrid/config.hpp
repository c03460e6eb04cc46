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

  // Labels
  /// Greatest height of a ground point above the ground. The paper: h_g, in ground cells.
  /// (paper: h_g, m)
  double ground_threshold_m = 0.2;
  /// Steps of the ground higher than this, such as kerbs, are obstacles; 0: off. Not with the
  /// paper's method. (m)
  double max_step_m = 0.0;

  // Confidence of the map (III-D, III-E)
  /// Points in a patch for full confidence (eq. 4). (paper: s)
  double confidence_point_scale = 20.0;
  /// Decay of confidence where a scan shows no ground (eq. 8). (paper: θ)
  double confidence_decay = 5.0;

  // Of the paper's method alone
  /// A ray may dip this far below the map and still be free. (paper: o_t, m)
  double outlier_tolerance_m = 0.1;
  /// Sum of confidence over 5x5 cells that a cell needs to block a ray. (paper: o_minc)
  double outlier_min_confidence = 1.25;
  /// Variance threshold per metre of distance (eq. 1). (paper: d_sf, m)
  double variance_distance_factor = 1e-5;
  /// Least variance threshold. (paper: t_minv, m²)
  double min_variance_threshold = 5e-5;
  /// Angle between neighbouring points of a beam (eq. 2). (paper: d_pv, deg)
  double point_angle_deg = 0.4;
  /// Share of the expected points that a cell needs. (paper: g_minp)
  double min_point_fraction = 0.25;
  /// Patches are 3x3 nearer than this, 5x5 beyond. (paper: d_ps, m)
  double patch_change_distance_m = 20.0;
  /// From this count on a cell's own variance is used. (paper: v_np)
  int own_variance_min_points = 10;
  /// Greatest height of a ground point in cells that are not ground. (paper: h_o, m)
  double obstacle_threshold_m = 0.1;

  // Execution
  /// Threads of the standard method, the others use one; 0 for one per core.
  int threads = 1;

  /// The paper's equations and its parameter section, to the letter.
  static Config paper();

  /// Throws std::invalid_argument that names the field, its value and the range allowed.
  void validate() const;
};

}  // namespace groundgrid
