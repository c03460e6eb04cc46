#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "groundgrid/export.hpp"

namespace groundgrid {

/// How the stages of a scan are computed.
enum class Method : std::uint8_t { standard, paper, reference };

/// A place in the map frame: x, y. (m)
using Point2 = std::array<double, 2>;
/// A box in base: min x, max x, min y, max y, min z, max z. (m)
using Box = std::array<double, 6>;

/// Every value that the labels and the terrain depend on. `Config{}` is what works best on the real
/// scans that we can measure; `Config::paper()` follows the paper to the letter. docs/method.md
/// explains each deviation of the default, groundgrid/parameters.hpp lists unit, range and the
/// paper's symbols. While the version is 0.x a minor version may add a field, which changes the
/// layout: compile again what includes this.
struct GROUNDGRID_EXPORT Config {
  /// standard: ours, which grew out of the paper's; paper: the paper's to the letter; reference:
  /// the standard one as plain code, slowly and with the same bits.
  Method method = Method::standard;

  struct Map {
    /// Side of the square map around the vehicle. (m)
    double extent_m = 120.0;
    /// Side of a cell. (paper: R, m)
    double resolution_m = 0.33;
    /// Map frame x, y of a cell's centre; by default the first pose's. (m)
    std::optional<Point2> anchor_m{};
    /// Points in a patch for full confidence (eq. 4). (paper: s)
    double confidence_point_scale = 20.0;
    /// Decay of confidence if a scan shows no ground (eq. 8). (paper: θ)
    double confidence_decay = 5.0;
  } map;

  struct Vehicle {
    /// Height of the (first) sensor above the ground; estimated if left out and the scan brings
    /// no mounting. (m)
    std::optional<double> sensor_height_m{};
    /// Points nearer to their sensor are unknown and never enter the map. (m)
    double min_range_m = 0.0;
    /// Points in this box around the ego vehicle are unknown: min x, max x, min y, max y, min z,
    /// max z in base. (m)
    std::optional<Box> ego_vehicle_box_m{};
  } vehicle;

  struct Labels {
    /// Greatest height of a ground point above the ground. The paper: h_g, in ground cells.
    /// (paper: h_g, m)
    double ground_threshold_m = 0.2;
    /// Steps of the ground higher than this, such as kerbs, are obstacles; 0: off. Not with the
    /// paper's method. (m)
    double max_step_m = 0.0;
  } labels;

  /// Of the paper's method alone.
  struct Paper {
    /// A ray may dip this far below the map and still be free. (paper: o_t, m)
    double outlier_tolerance_m = 0.1;
    /// Sum of confidence over 5x5 cells that a cell needs to block a ray. (paper: o_minc)
    double outlier_min_confidence = 1.25;
    /// Variance threshold per metre of distance (eq. 1). (paper: d_sf, m)
    double variance_distance_factor = 1e-5;
    /// Least variance threshold. (paper: t_minv, m²)
    double min_variance_threshold = 5e-5;
    /// Angle between neighbouring points of a beam (eq. 2). (paper: d_pv, deg)
    double azimuth_resolution_deg = 0.4;
    /// Share of the expected points that a cell needs. (paper: g_minp)
    double min_point_fraction = 0.25;
    /// Patches are 3x3 nearer than this, 5x5 beyond. (paper: d_ps, m)
    double patch_change_distance_m = 20.0;
    /// From this count on a cell's own variance is used. (paper: v_np)
    int own_variance_min_points = 10;
    /// Greatest height of a ground point in cells that are not ground. (paper: h_o, m)
    double obstacle_threshold_m = 0.1;
  } paper_only;

  /// The paper's equations and its parameter section, to the letter.
  static Config paper();

  /// Throws std::invalid_argument that names the field, its value and the range allowed.
  void validate() const;
};

}  // namespace groundgrid
