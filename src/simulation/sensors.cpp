#include "simulation/sensors.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "simulation/built_in_sensors.hpp"
#include "simulation/sensor_file.hpp"

namespace groundgrid::simulation {

Eigen::Vector3d Sensor::direction(const Beam& beam, int column, std::size_t scan) const {
  constexpr double kTurn = 2.0 * std::numbers::pi;
  if (sweep == Sweep::rosette) {
    const double turn = static_cast<double>(scan) + time_share(column);
    const double fast = kTurn * 16.17 * turn;
    const double slow = -kTurn * 9.73 * turn;
    const double half = cone_rad / 2.0;
    const double azimuth = half * (std::cos(fast) + std::cos(slow)) + beam.azimuth_rad;
    const double elevation = half * (std::sin(fast) + std::sin(slow)) + beam.elevation_rad;
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
  }
  const double azimuth = -kTurn * time_share(column) + beam.azimuth_rad;
  return {std::cos(beam.elevation_rad) * std::cos(azimuth),
          std::cos(beam.elevation_rad) * std::sin(azimuth), std::sin(beam.elevation_rad)};
}

double Sensor::time_share(int column) const { return (column + 0.5) / columns - 0.5; }

Eigen::Isometry3d Sensor::T_base_sensor() const {
  return Eigen::Translation3d(mount.x_m, mount.y_m, mount.height_m) *
         Eigen::AngleAxisd(mount.yaw_rad, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(mount.pitch_rad, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(mount.roll_rad, Eigen::Vector3d::UnitX());
}

std::vector<std::string> sensor_names() {
  std::vector<std::string> names;
  for (const BuiltInSensor& sensor : built_in_sensors()) names.emplace_back(sensor.name);
  return names;
}

Sensor make_sensor(const std::string& name) {
  const auto sensors = built_in_sensors();
  const auto found = std::find_if(sensors.begin(), sensors.end(),
                                  [&](const BuiltInSensor& each) { return each.name == name; });
  if (found == sensors.end()) throw std::invalid_argument("there is no sensor '" + name + "'");
  return parse_sensor(found->text, name + ".toml");
}

}  // namespace groundgrid::simulation
