#include "simulation/scene_builder.hpp"

#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kHalfWheelbase_m = 1.4;
constexpr double kHalfCarTrack_m = 0.75;

}  // namespace

std::vector<double> every(double step_m, double from_m, double to_m) {
  std::vector<double> stations;
  while (from_m < to_m) {
    stations.push_back(from_m);
    from_m += step_m;
  }
  return stations;
}

SceneBuilder::SceneBuilder(std::uint64_t seed, std::vector<Bend> bends, double length_m)
    : seed_(seed) {
  scene_.path = std::make_shared<const Path>(std::move(bends), length_m, kMargin_m);
}

double SceneBuilder::height(Station station) const {
  return scene_.ground(path().point(station)).height_m;
}

Eigen::Isometry3d SceneBuilder::pose(Station station, double turn) const {
  const Eigen::Vector2d place = path().point(station);
  return Eigen::Translation3d(place.x(), place.y(), scene_.ground(place).height_m) *
         Eigen::AngleAxisd(path().heading(station.s) + turn, Eigen::Vector3d::UnitZ());
}

void SceneBuilder::place(const Mesh& object, Station station, double turn) {
  scene_.solids.append(object, pose(station, turn));
}

void SceneBuilder::place(const Plant& plant, Station station, double turn) {
  const Eigen::Isometry3d T_world_plant = pose(station, turn);
  scene_.solids.append(plant.wood, T_world_plant);
  scene_.leaves.append(plant.leaves, T_world_plant);
}

void SceneBuilder::park(const Mesh& object, Station station, double turn) {
  const auto slope = [&](double ahead_m, double left_m) {
    const double far = height({station.s + ahead_m, station.d + left_m});
    const double near = height({station.s - ahead_m, station.d - left_m});
    return (far - near) / (2.0 * (ahead_m + left_m));
  };
  const Eigen::Vector3d up(-slope(kHalfWheelbase_m, 0.0), -slope(0.0, kHalfCarTrack_m), 1.0);
  const Eigen::AngleAxisd heading(path().heading(station.s), Eigen::Vector3d::UnitZ());
  Eigen::Isometry3d tilted = pose(station, turn);
  tilted.linear() =
      Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), heading * up) * tilted.linear();
  scene_.solids.append(object, tilted);
}

void SceneBuilder::add_mover(Mesh mesh, Station start, double speed_mps) {
  scene_.movers.push_back({std::move(mesh), start, speed_mps});
}

}  // namespace groundgrid::simulation
