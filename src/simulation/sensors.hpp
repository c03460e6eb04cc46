#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <string>
#include <vector>

namespace groundgrid::simulation {

/// One laser of a sensor.
struct Beam {
  double elevation_rad = 0.0;
  double azimuth_rad = 0.0;  ///< Offset from where the sensor points.
  double height_m = 0.0;     ///< Of its origin above that of the sensor.
};

/// How the lasers sweep.
enum class Sweep : std::uint8_t {
  turning,  ///< Clockwise through a full turn, from the rear over the left to the front and on.
  rosette,  ///< Two prisms that never repeat their figure, within a cone about the front.
};

/// Where a sensor sits on the vehicle, whose base is on the ground under its middle.
struct Mount {
  double height_m = 0.0;  ///< Above the base.
  double x_m = 0.0;       ///< Before the base.
  double y_m = 0.0;       ///< Left of it.
  double roll_rad = 0.0;  ///< About x, then pitch about y, then yaw about z, all of the base.
  double pitch_rad = 0.0;
  double yaw_rad = 0.0;
};

/// A LiDAR and where it sits on the vehicle.
struct Sensor {
  std::string name{};
  Sweep sweep = Sweep::turning;
  std::vector<Beam> beams{};  ///< From the highest to the lowest.
  int columns = 0;            ///< Directions of each laser in a scan.
  double cone_rad = 0.0;      ///< Half the opening of a rosette.
  double rate_hz = 10.0;
  double least_range_m = 0.9;
  double most_range_m = 80.0;
  double noise_m = 0.02;  ///< Standard deviation of a range.
  double bias_m = 0.008;  ///< The same of what is always added to the ranges of one laser.
  double range_step_m = 0.002;
  Mount mount{};

  /// Where a laser looks in a column of a scan, of length 1, in the sensor's frame.
  [[nodiscard]] Eigen::Vector3d direction(const Beam& beam, int column, std::size_t scan) const;

  /// When a column is measured, as a share of the scan from -0.5 to 0.5.
  [[nodiscard]] double time_share(int column) const;

  [[nodiscard]] Eigen::Isometry3d T_base_sensor() const;
};

/// The names of the sensors that come with the library, HDL-64E first.
std::vector<std::string> sensor_names();

/// A sensor by its name. Throws std::invalid_argument where there is none.
Sensor make_sensor(const std::string& name);

}  // namespace groundgrid::simulation
