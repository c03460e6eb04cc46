#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "core/parallel.hpp"
#include "simulation/drive.hpp"
#include "simulation/echo.hpp"
#include "simulation/sensors.hpp"

namespace groundgrid::simulation {

/// One simulated scan with all that is true of it.
struct Scan {
  std::vector<float> points{};          ///< x y z intensity, in the sensor's frame.
  std::vector<std::uint32_t> labels{};  ///< SemanticKITTI, of each point.
  std::vector<float> heights{};         ///< Metres above the soil, of each point.
  Eigen::Isometry3d T_world_sensor = Eigen::Isometry3d::Identity();
};

/// What the motion of the vehicle within a scan does to its points.
enum class Motion : std::uint8_t {
  corrected,  ///< All points are in the frame of the middle of the scan, as in KITTI.
  distorted,  ///< Each point is as the sensor saw it when it measured it.
};

/// Sends out the rays of a sensor that drives through a world.
class Scanner {
 public:
  /// World and drive must outlive the scanner.
  Scanner(World& world, const Drive& drive, Sensor sensor, Motion motion, std::uint64_t seed,
          TileRunner& runner);

  /// Points lie in the order of the sensor's beams, and of its columns within a beam.
  Scan scan(std::size_t index);

 private:
  struct Column {
    Eigen::Isometry3d T_world_sensor;
    Eigen::Isometry3d T_frame_sensor;
  };
  void place_columns(std::size_t index, Scan& scan);
  [[nodiscard]] Ray ray(std::size_t ray_index, std::size_t scan_index) const;
  [[nodiscard]] Echo measure(std::size_t ray_index, std::size_t scan_index) const;
  void mix_edges(std::size_t scan_index);
  void collect(std::size_t scan_index, Scan& scan) const;

  World* world_;
  const Drive* drive_;
  Sensor sensor_;
  Motion motion_;
  std::uint64_t seed_;
  TileRunner* runner_;
  Eigen::Isometry3d T_base_sensor_;
  Mesh own_vehicle_mesh_;
  RayCaster own_vehicle_;
  std::vector<double> bias_m_;  ///< Of each beam.
  std::vector<Column> columns_;
  std::vector<Echo> echoes_;
  std::vector<Echo> mixed_;
};

}  // namespace groundgrid::simulation
