#include "simulation/scanner.hpp"

#include <utility>

#include "simulation/noise.hpp"
#include "simulation/objects.hpp"
#include "simulation/own_vehicle.hpp"

namespace groundgrid::simulation {
namespace {

constexpr std::size_t kRaysPerTile = 2048;
constexpr double kOwnVehicle_m = 4.0;

enum Purpose : std::uint64_t { kEcho = 10, kEdge = 11, kRange = 12 };

}  // namespace

Scanner::Scanner(World& world, const Drive& drive, Sensor sensor, Motion motion, std::uint64_t seed,
                 TileRunner& runner)
    : world_(&world),
      drive_(&drive),
      sensor_(std::move(sensor)),
      motion_(motion),
      seed_(seed),
      runner_(&runner),
      T_base_sensor_(sensor_.T_base_sensor()),
      own_vehicle_mesh_(make_own_vehicle(sensor_.mount.height_m)),
      own_vehicle_({&own_vehicle_mesh_}),
      columns_(static_cast<std::size_t>(sensor_.columns)),
      echoes_(sensor_.beams.size() * columns_.size()),
      mixed_(echoes_.size()) {
  for (std::size_t beam = 0; beam < sensor_.beams.size(); ++beam)
    bias_m_.push_back(beam_bias(sensor_, beam, seed));
}

Scan Scanner::scan(std::size_t index) {
  Scan scan;
  place_columns(index, scan);
  world_->move_to(static_cast<double>(index) / sensor_.rate_hz,
                  scan.T_world_sensor.translation().head<2>());
  runner_->parallel_for_ranges(echoes_.size(), kRaysPerTile,
                               [&](std::size_t begin, std::size_t end) {
                                 for (std::size_t i = begin; i < end; ++i)
                                   echoes_[i] = measure(i, index);
                               });
  mix_edges(index);
  collect(index, scan);
  return scan;
}

void Scanner::place_columns(std::size_t index, Scan& scan) {
  const auto pose_at = [&](double share) {
    return drive_->pose((static_cast<double>(index) + share) / sensor_.rate_hz) * T_base_sensor_;
  };
  scan.T_world_sensor = pose_at(0.0);
  const Eigen::Isometry3d T_sensor_world = scan.T_world_sensor.inverse();
  for (std::size_t i = 0; i < columns_.size(); ++i) {
    Column& column = columns_[i];
    column.T_world_sensor = pose_at(sensor_.time_share(static_cast<int>(i)));
    column.T_frame_sensor = motion_ == Motion::corrected ? T_sensor_world * column.T_world_sensor
                                                         : Eigen::Isometry3d::Identity();
  }
}

Ray Scanner::ray(std::size_t ray_index, std::size_t scan_index) const {
  const Beam& beam = sensor_.beams[ray_index / columns_.size()];
  const std::size_t column = ray_index % columns_.size();
  return {{0.0, 0.0, beam.height_m}, sensor_.direction(beam, static_cast<int>(column), scan_index)};
}

Echo Scanner::measure(std::size_t ray_index, std::size_t scan_index) const {
  const Ray in_sensor = ray(ray_index, scan_index);
  const Ray in_base{T_base_sensor_ * in_sensor.origin,
                    T_base_sensor_.linear() * in_sensor.direction};
  if (const auto hit = own_vehicle_.cast(in_base, 0.0, kOwnVehicle_m)) {
    const float reflectivity = own_vehicle_mesh_.surface(hit->triangle).reflectivity;
    return {reflectivity > 0.0F ? hit->distance_m : 0.0, label::kUnlabeled, reflectivity};
  }
  const Eigen::Isometry3d& T_world_sensor = columns_[ray_index % columns_.size()].T_world_sensor;
  return world_->echo(
      {T_world_sensor * in_sensor.origin, T_world_sensor.linear() * in_sensor.direction},
      sensor_.least_range_m, sensor_.most_range_m,
      Random(hash({seed_, kEcho, scan_index, ray_index})));
}

void Scanner::mix_edges(std::size_t scan_index) {
  for (std::size_t i = 0; i < echoes_.size(); ++i) {
    mixed_[i] = echoes_[i];
    const bool last_of_beam = i % columns_.size() + 1 == columns_.size();
    if (last_of_beam || !(echoes_[i].distance_m > 0.0)) continue;
    Random random(hash({seed_, kEdge, scan_index, i}));
    mixed_[i] = mixed_at_edge(echoes_[i], echoes_[i + 1], random);
  }
}

void Scanner::collect(std::size_t scan_index, Scan& scan) const {
  for (std::size_t i = 0; i < mixed_.size(); ++i) {
    const Echo& echo = mixed_[i];
    if (!(echo.distance_m > 0.0)) continue;
    Random random(hash({seed_, kRange, scan_index, i}));
    const double range =
        measured_range(sensor_, echo.distance_m, bias_m_[i / columns_.size()], random);
    if (!(range > 0.0)) continue;
    const Ray in_sensor = ray(i, scan_index);
    const Eigen::Vector3d point = in_sensor.origin + range * in_sensor.direction;
    const Column& column = columns_[i % columns_.size()];
    const Eigen::Vector3f stored = (column.T_frame_sensor * point).cast<float>();
    const Eigen::Vector3d in_world = column.T_world_sensor * point;
    scan.points.insert(scan.points.end(), {stored.x(), stored.y(), stored.z(), echo.intensity});
    scan.labels.push_back(echo.label);
    scan.heights.push_back(
        static_cast<float>(in_world.z() - world_->terrain().height(in_world.head<2>())));
  }
}

}  // namespace groundgrid::simulation
