#include "simulation/sensors.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string_view>

namespace groundgrid::simulation {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180.0;

Eigen::Isometry3d at_height(double height_m) {
  return Eigen::Isometry3d(Eigen::Translation3d(0.0, 0.0, height_m));
}

/// Evenly spread from `highest_deg` to `lowest_deg`.
std::vector<Beam> spread(int count, double highest_deg, double lowest_deg) {
  std::vector<Beam> beams;
  for (int i = 0; i < count; ++i)
    beams.push_back(
        {.elevation_rad = kDegree * (highest_deg + (lowest_deg - highest_deg) * i / (count - 1))});
  return beams;
}

/// Two blocks of 32 lasers, one above the other; the lasers of a block fire together in four
/// columns that lie some degrees apart. All heights are above the origin of the points, which in
/// KITTI lies at the foot of the sensor.
Sensor hdl_64e() {
  Sensor sensor{.name = "hdl-64e", .columns = 2083, .T_base_sensor = at_height(1.73)};
  constexpr std::array kColumns_deg{-3.9, 1.3, -1.3, 3.9};
  for (const auto& [block, height] :
       {std::pair{spread(32, 2.0, -8.33), 0.21}, std::pair{spread(32, -8.83, -24.8), 0.12}})
    for (std::size_t i = 0; i < block.size(); ++i) {
      Beam beam = block[i];
      beam.azimuth_rad = kDegree * kColumns_deg[i % kColumns_deg.size()];
      beam.height_m = height;
      sensor.beams.push_back(beam);
    }
  return sensor;
}

/// As nuScenes mounts it: 20 turns a second, so half the columns that it has at 10.
Sensor hdl_32e() {
  Sensor sensor{.name = "hdl-32e", .beams = spread(32, 10.67, -30.67), .columns = 1086};
  sensor.rate_hz = 20.0;
  sensor.most_range_m = 70.0;
  sensor.T_base_sensor = at_height(1.84);
  return sensor;
}

Sensor vlp_16() {
  Sensor sensor{.name = "vlp-16", .beams = spread(16, 15.0, -15.0), .columns = 1800};
  sensor.T_base_sensor = at_height(1.2);
  return sensor;
}

Sensor os1_128() {
  Sensor sensor{.name = "os1-128", .beams = spread(128, 22.5, -22.5), .columns = 1024};
  sensor.T_base_sensor = at_height(1.8);
  return sensor;
}

/// Six lasers side by side that draw a rosette within a cone of 70 degrees ahead, as a Livox does.
Sensor rosette() {
  Sensor sensor{.name = "rosette", .sweep = Sweep::rosette, .columns = 4000};
  for (int i = 0; i < 6; ++i) sensor.beams.push_back({.elevation_rad = kDegree * (0.5 - 0.2 * i)});
  sensor.cone_rad = kDegree * 35.0;
  sensor.T_base_sensor = at_height(1.5);
  return sensor;
}

struct Entry {
  std::string_view name;
  Sensor (*make)();
};
constexpr std::array kEntries{Entry{"hdl-64e", hdl_64e}, Entry{"hdl-32e", hdl_32e},
                              Entry{"vlp-16", vlp_16}, Entry{"os1-128", os1_128},
                              Entry{"rosette", rosette}};

}  // namespace

Eigen::Vector3d Sensor::direction(const Beam& beam, int column, std::size_t scan) const {
  if (sweep == Sweep::rosette) {
    const double turn = static_cast<double>(scan) + time_share(column);
    const double fast = 2.0 * kPi * 16.17 * turn;
    const double slow = -2.0 * kPi * 9.73 * turn;
    const double half = cone_rad / 2.0;
    const double azimuth = half * (std::cos(fast) + std::cos(slow)) + beam.azimuth_rad;
    const double elevation = half * (std::sin(fast) + std::sin(slow)) + beam.elevation_rad;
    return {std::cos(elevation) * std::cos(azimuth), std::cos(elevation) * std::sin(azimuth),
            std::sin(elevation)};
  }
  const double azimuth = -2.0 * kPi * time_share(column) + beam.azimuth_rad;
  return {std::cos(beam.elevation_rad) * std::cos(azimuth),
          std::cos(beam.elevation_rad) * std::sin(azimuth), std::sin(beam.elevation_rad)};
}

double Sensor::time_share(int column) const { return (column + 0.5) / columns - 0.5; }

const std::vector<std::string>& sensor_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> all(kEntries.size());
    std::transform(kEntries.begin(), kEntries.end(), all.begin(),
                   [](const Entry& each) { return std::string(each.name); });
    return all;
  }();
  return names;
}

Sensor make_sensor(const std::string& name) {
  const auto* const found = std::find_if(kEntries.begin(), kEntries.end(),
                                         [&](const Entry& each) { return each.name == name; });
  if (found == kEntries.end()) throw std::invalid_argument("there is no sensor '" + name + "'");
  return found->make();
}

}  // namespace groundgrid::simulation
