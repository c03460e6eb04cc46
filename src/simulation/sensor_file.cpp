#include "simulation/sensor_file.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

#include "io/error.hpp"
#include "io/input_file.hpp"
#include "simulation/scenes.hpp"
#include "simulation/sensor_fields.hpp"

namespace groundgrid::simulation {
namespace {

constexpr std::size_t kMostBytes = 65536;
constexpr std::size_t kMostBeams = 256;
constexpr double kDegree = std::numbers::pi / 180.0;
constexpr Limits kElevations_deg{-90.0, 90.0};
constexpr Limits kTurns_deg{-180.0, 180.0};

Sensor start_of(SensorFields& fields) {
  const auto like = fields.word("like");
  if (!like) return {};
  try {
    return make_sensor(*like);
  } catch (const std::invalid_argument& error) {
    fields.fail("like", "the name of a sensor", error.what());
  }
}

void read_sweep(SensorFields& fields, Sensor& sensor) {
  const auto pattern = fields.word("pattern");
  if (pattern && *pattern != "turning" && *pattern != "rosette")
    fields.fail("pattern", "turning or rosette", io::in_quotes(*pattern));
  if (pattern) sensor.sweep = *pattern == "rosette" ? Sweep::rosette : Sweep::turning;
  if (const auto cone = fields.number("cone_deg", {1.0, 170.0}))
    sensor.cone_rad = *cone / 2.0 * kDegree;
  if (sensor.sweep == Sweep::rosette && !(sensor.cone_rad > 0.0))
    fields.fail("cone_deg", "the opening of the rosette", "nothing");
  const auto columns = fields.number("columns", {1.0, 10000.0});
  if (columns && *columns != std::floor(*columns))
    fields.fail("columns", "a whole number", fmt::format("{}", *columns));
  if (columns) sensor.columns = static_cast<int>(*columns);
  if (sensor.columns == 0) fields.fail("columns", "a whole number", "nothing");
}

void require_count(const SensorFields& fields, const std::string& name, std::size_t got,
                   std::size_t expected) {
  if (got != expected)
    fields.fail(name, fmt::format("{} numbers, one for each laser", expected),
                fmt::format("{}", got));
}

void read_beams(SensorFields& fields, Sensor& sensor) {
  if (const auto elevations = fields.numbers("elevations_deg", kElevations_deg)) {
    if (elevations->size() > kMostBeams)
      fields.fail("elevations_deg", fmt::format("at most {} lasers", kMostBeams),
                  fmt::format("{}", elevations->size()));
    sensor.beams.clear();
    for (const double elevation : *elevations)
      sensor.beams.push_back({.elevation_rad = elevation * kDegree});
  }
  if (sensor.beams.empty()) fields.fail("elevations_deg", "a number for each laser", "none");
  if (const auto azimuths = fields.numbers("azimuths_deg", kTurns_deg)) {
    require_count(fields, "azimuths_deg", azimuths->size(), sensor.beams.size());
    for (std::size_t i = 0; i < sensor.beams.size(); ++i)
      sensor.beams[i].azimuth_rad = (*azimuths)[i] * kDegree;
  }
  if (const auto heights = fields.numbers("origin_heights_m", {-1.0, 1.0})) {
    require_count(fields, "origin_heights_m", heights->size(), sensor.beams.size());
    for (std::size_t i = 0; i < sensor.beams.size(); ++i) sensor.beams[i].height_m = (*heights)[i];
  }
}

void read_ranges(SensorFields& fields, Sensor& sensor) {
  sensor.rate_hz = fields.number("rate_hz", {0.1, 100.0}).value_or(sensor.rate_hz);
  sensor.least_range_m =
      fields.number("least_range_m", {0.05, kMargin_m}).value_or(sensor.least_range_m);
  sensor.most_range_m =
      fields.number("most_range_m", {1.0, kMargin_m}).value_or(sensor.most_range_m);
  if (sensor.least_range_m >= sensor.most_range_m)
    fields.fail("least_range_m", fmt::format("less than most_range_m, {}", sensor.most_range_m),
                fmt::format("{}", sensor.least_range_m));
  sensor.noise_m = fields.number("noise_m", {0.0, 1.0}).value_or(sensor.noise_m);
  sensor.bias_m = fields.number("bias_m", {0.0, 1.0}).value_or(sensor.bias_m);
  sensor.range_step_m = fields.number("range_step_m", {1e-6, 1.0}).value_or(sensor.range_step_m);
}

void read_mount(SensorFields& fields, Mount& mount) {
  mount.height_m = fields.number("height_m", {0.2, 5.0}).value_or(mount.height_m);
  if (!(mount.height_m > 0.0)) fields.fail("height_m", "metres over the ground", "nothing");
  mount.x_m = fields.number("x_m", {-5.0, 5.0}).value_or(mount.x_m);
  mount.y_m = fields.number("y_m", {-2.0, 2.0}).value_or(mount.y_m);
  const auto read_angle = [&](const char* name, double& angle_rad) {
    if (const auto angle = fields.number(name, kTurns_deg)) angle_rad = *angle * kDegree;
  };
  read_angle("roll_deg", mount.roll_rad);
  read_angle("pitch_deg", mount.pitch_rad);
  read_angle("yaw_deg", mount.yaw_rad);
}

}  // namespace

Sensor parse_sensor(std::string_view text, const std::filesystem::path& file) {
  SensorFields fields(text, file);
  Sensor sensor = start_of(fields);
  sensor.name = file.stem().string();
  read_sweep(fields, sensor);
  read_beams(fields, sensor);
  read_ranges(fields, sensor);
  read_mount(fields, sensor.mount);
  fields.require_all_taken();
  return sensor;
}

Sensor read_sensor(const std::filesystem::path& path) {
  io::InputFile file(path);
  if (file.size() > kMostBytes)
    throw io::Error({.file = path,
                     .expected = fmt::format("a sensor file of at most {} bytes", kMostBytes),
                     .got = fmt::format("{} bytes", file.size())});
  std::string text;
  file.read_into(text, static_cast<std::size_t>(file.size()));
  return parse_sensor(text, path);
}

}  // namespace groundgrid::simulation
