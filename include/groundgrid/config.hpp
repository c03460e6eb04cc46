#pragma once

#include <optional>

namespace groundgrid {

/// Every value the method depends on. `Config{}` is what works best on the real scans we can
/// measure; `Config::paper()` follows the paper to the letter. docs/method.md explains each
/// deviation of the default, groundgrid/parameters.hpp lists unit, range and paper symbol.
struct Config {
  // Map
  double map_extent_m = 120.0;
  double cell_size_m = 0.33;
  std::optional<double> grid_anchor_x_m{};
  std::optional<double> grid_anchor_y_m{};
  double pose_jump_m = 20.0;

  // Vehicle and sensor
  std::optional<double> sensor_height_m{};
  double min_range_m = 0.0;
  double own_vehicle_min_x_m = 0.0;
  double own_vehicle_max_x_m = 0.0;
  double own_vehicle_min_y_m = 0.0;
  double own_vehicle_max_y_m = 0.0;
  double own_vehicle_min_z_m = 0.0;
  double own_vehicle_max_z_m = 0.0;

  // Outlier filter (III-A)
  double outlier_tolerance_m = 0.1;
  double outlier_min_confidence = 8.0;
  double outlier_min_depth_m = 0.3;

  // Ground cells (III-C)
  double variance_distance_factor = 5e-5;
  double min_variance_threshold = 5e-4;
  double point_angle_deg = 0.4;
  double min_point_fraction = 0.25;
  double patch_change_distance_m = 40.0;
  int own_variance_min_points = 5;
  bool reject_raised = true;
  double envelope_slope = 0.25;
  double envelope_step_m = 0.15;
  double envelope_pit_m = 0.3;

  // Elevation and confidence (III-D)
  double confidence_point_scale = 20.0;

  // Interpolation (III-E)
  double confidence_decay = 5.0;

  // Segmentation (III-F)
  double ground_threshold_m = 0.2;
  double obstacle_threshold_m = 0.1;
  bool threshold_by_column = true;
  double tall_height_m = 0.3;
  double overhang_height_m = 1.0;
  double tall_threshold_m = 0.06;
  double level_band_m = 0.15;

  // Execution
  int threads = 1;

  /// The paper's equations and its parameter section, to the letter.
  static Config paper();

  /// Throws std::invalid_argument that names the field, its value and the range allowed.
  void validate() const;
};

}  // namespace groundgrid
