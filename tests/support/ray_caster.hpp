#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "groundgrid/ground_grid.hpp"
#include "groundgrid/scan.hpp"

namespace groundgrid::testing {

/// What a point really is. `foot` is an obstacle within 0.35 m of the ground, which no method with
/// the paper's thresholds can tell from it; it is not counted.
enum class Truth : std::uint8_t { ground, obstacle, foot };

/// A box along the axes of the map.
struct SolidBox {
  Eigen::Vector3d min;
  Eigen::Vector3d max;
  bool is_ground = false;  ///< A kerb with its pavement, not an obstacle.
};

/// A plane, z = slope_x · x, and boxes.
struct Scene {
  double slope_x = 0.0;
  std::vector<SolidBox> boxes{};
};

/// A spinning LiDAR: beams evenly between two elevations, azimuths evenly around, in the order in
/// which a real one delivers them.
struct SpinningSensor {
  int beams = 32;
  double lowest_deg = -25.0;
  double highest_deg = 3.0;
  int azimuths = 720;
  double max_range_m = 55.0;  ///< Less than half the side of the default map.
  double first_azimuth_deg = 0.0;
  double noise_m = 0.01;  ///< Half the width of an even distribution of the range error.
};

/// A scan and its truth. Records are 24 bytes: x, y, z, padding, time in seconds.
struct SimulatedScan {
  struct Record {
    float x, y, z, padding;
    double time;
  };
  std::vector<Record> records;
  std::vector<Truth> truth;

  [[nodiscard]] PointView view() const;
  /// As packed floats: x, y, z.
  [[nodiscard]] std::vector<float> packed() const;
};

/// Casts one scan while the vehicle moves evenly from one pose to the other; times are from 0 to
/// 0.1 s. Rays that hit nothing bring no point.
SimulatedScan cast_scan(const Scene& scene, const SpinningSensor& sensor,
                        const Eigen::Isometry3d& T_map_base_begin,
                        const Eigen::Isometry3d& T_map_base_end,
                        const Eigen::Isometry3d& T_base_sensor, unsigned seed);

/// The same with the vehicle at rest.
SimulatedScan cast_scan(const Scene& scene, const SpinningSensor& sensor,
                        const Eigen::Isometry3d& T_map_base, const Eigen::Isometry3d& T_base_sensor,
                        unsigned seed);

/// How well the labels agree with the truth.
struct Score {
  std::size_t ground_points = 0;
  std::size_t obstacle_points = 0;
  std::size_t ground_found = 0;    ///< Ground points called ground.
  std::size_t obstacle_found = 0;  ///< Obstacle points called obstacle.
  std::size_t outliers = 0;        ///< Points called outlier, whatever they are.
  std::size_t unknown = 0;

  void add(const Score& other);
  [[nodiscard]] double ground_recall() const;
  [[nodiscard]] double obstacle_recall() const;
};

/// Labels may be longer than truth: `first` is the first point's.
Score score(std::span<const Label> labels, const std::vector<Truth>& truth, std::size_t first = 0);

/// A pose from a position and an angle about z, for readable tests.
Eigen::Isometry3d pose(double x, double y, double z, double yaw_deg = 0.0);

}  // namespace groundgrid::testing
