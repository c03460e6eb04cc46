// A motorway with guard rails, slopes of 30 to 40 % down to ditches or up from them, lorries, and
// bridges over it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kMedian_m = 1.6;    // Half its width.
constexpr double kShoulder_m = 9.3;  // Where the hard shoulder begins.
constexpr double kAsphalt_m = 12.0;
constexpr double kVerge_m = 14.0;  // Where the slope begins.
constexpr double kSlope_m = 6.0;   // Its width.
constexpr double kRightLane_m = 7.4;
constexpr double kLeftLane_m = 3.6;
constexpr double kBetweenBridges_m = 260.0;
constexpr double kFirstBridge_m = 90.0;

class Motorway {
 public:
  Motorway(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double level = relief_.height(path_->point({at.s, 0.0}));
    return cover(at, beside, level + profile(at, beside) + roughness(place, beside));
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    return {{4.0, {2.0 * kPi / 700.0, 0.0}, Random(hash({seed, 100})).uniform(0.0, 2.0 * kPi)}};
  }

  [[nodiscard]] double roughness(const Eigen::Vector2d& place, double beside) const {
    return 0.04 * bumps(place, 1.5, seed_) * smooth_step(kAsphalt_m, kVerge_m, beside) +
           0.5 * bumps(place, 25.0, seed_ + 1) * smooth_step(kVerge_m + kSlope_m, 40.0, beside);
  }

  /// The slope of each side: 0.3 to 0.4 down to a ditch, or up from one.
  [[nodiscard]] double slope(Station at) const {
    const double turn = 2.0 * kPi * at.s / 240.0 + (at.d < 0.0 ? 0.0 : 2.0);
    return 0.4 * std::tanh(3.0 * std::sin(turn + static_cast<double>(seed_ % 7U)));
  }

  [[nodiscard]] double profile(Station at, double beside) const {
    const double fall = beside < kMedian_m ? 0.0 : -0.02 * (std::min(beside, kVerge_m) - kMedian_m);
    const double down = std::clamp(beside - kVerge_m, 0.0, kSlope_m);
    const double ditch = (beside - kVerge_m - 1.0) / 1.0;
    const double rise = slope(at);
    const double hollow = rise > 0.0 ? -0.45 * std::max(0.0, 1.0 - ditch * ditch) : 0.0;
    return fall + rise * down + hollow;
  }

  static bool is_marking(Station at, double beside) {
    const bool dashed = std::fmod(at.s + 1800.0, 18.0) < 6.0;
    return std::abs(beside - 1.9) < 0.12 || std::abs(beside - kShoulder_m) < 0.15 ||
           (dashed && std::abs(beside - 5.5) < 0.08);
  }

  static Ground cover(Station at, double beside, double height) {
    if (beside < kMedian_m) return {height, label::kTerrain, 0.12};
    if (beside < kAsphalt_m)
      return {height, is_marking(at, beside) ? label::kLaneMarking : label::kRoad, 0.0};
    return {height, label::kTerrain, beside < kVerge_m ? 0.08 : 0.2};
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

Mesh guard_rail(double length_m) {
  Mesh mesh;
  const std::uint32_t steel = mesh.add_surface({.label = label::kFence, .reflectivity = 0.5F});
  add_box(mesh, {0.0, -0.06, 0.45}, {length_m, 0.06, 0.76}, steel);
  add_box(mesh, {0.0, -0.05, -0.3}, {0.12, 0.05, 0.5}, steel);
  return mesh;
}

void add_rails(SceneBuilder& motorway) {
  constexpr double kPiece_m = 4.0;
  for (double s = motorway.path().first(); s < motorway.path().last(); s += kPiece_m)
    for (const double d : {-kAsphalt_m - 0.8, -0.9, 0.9, kAsphalt_m + 0.8})
      motorway.place(guard_rail(kPiece_m + 0.02), {s, d});
}

Mesh bridge() {
  Mesh mesh;
  const std::uint32_t concrete =
      mesh.add_surface({.label = label::kOtherStructure, .reflectivity = 0.35F});
  add_box(mesh, {-4.5, -30.0, 4.9}, {4.5, 30.0, 6.0}, concrete);
  for (const double side : {-1.0, 1.0})
    add_box(mesh, {-4.5 * side - 0.1, -30.0, 6.0}, {-4.5 * side + 0.1, 30.0, 7.0}, concrete);
  for (const double y : {-14.5, 0.0, 14.5})
    for (const double x : {-3.0, 0.0, 3.0})
      add_cylinder(mesh, {x, y, -2.0}, 0.45, 0.45, 7.0, 12, concrete);
  return mesh;
}

void add_traffic(SceneBuilder& motorway, double lane_m, double speed_mps, double from_m,
                 double lorries) {
  Random random = motorway.next_random();
  const double last = motorway.path().last() * 3.0;
  for (double s = from_m; s < last; s += random.uniform(35.0, 80.0)) {
    const std::uint16_t instance = motorway.next_instance();
    const Random next = motorway.next_random();
    motorway.add_mover(random.chance(lorries) ? make_lorry(next, label::kMovingTruck, instance)
                                              : make_car(next, label::kMovingCar, instance),
                       {s, lane_m}, speed_mps);
  }
}

void plant_slopes(SceneBuilder& motorway) {
  for (double s = motorway.path().first(); s < motorway.path().last(); s += 5.0)
    for (const double side : {-1.0, 1.0}) {
      Random random = motorway.next_random();
      if (random.chance(0.6))
        motorway.place(make_bush(random, random.uniform(0.6, 1.6), random.uniform(0.8, 2.2)),
                       {s, side * random.uniform(17.0, 30.0)});
      if (random.chance(0.35))
        motorway.place(make_tree(motorway.next_random(), random.uniform(1.0, 2.5),
                                 random.uniform(1.5, 3.0), random.uniform(5.0, 10.0)),
                       {s + 2.0, side * random.uniform(21.0, 40.0)});
    }
}

}  // namespace

Scene make_motorway(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder motorway(seed, {{random.uniform(0.05, 0.1), 500.0, random.uniform(0.0, 2.0 * kPi)}},
                        length_m);
  motorway.set_ground(Motorway(motorway.shared_path(), seed));
  motorway.set_lane(-kRightLane_m);
  add_rails(motorway);
  plant_slopes(motorway);
  for (double s = kFirstBridge_m; s < motorway.path().last(); s += kBetweenBridges_m)
    motorway.place(bridge(), {s, 0.0});
  for (double s = 30.0; s < motorway.path().last(); s += 110.0) {
    motorway.place(make_sign(random), {s, -kAsphalt_m - 1.4});
    motorway.place(make_pole(9.0, 0.12), {s + 40.0, -kAsphalt_m - 1.6});
  }
  add_traffic(motorway, -kRightLane_m, 20.0, 45.0, 0.5);
  add_traffic(motorway, -kLeftLane_m, 26.0, -90.0, 0.0);
  add_traffic(motorway, kRightLane_m, -22.0, 20.0, 0.5);
  add_traffic(motorway, kLeftLane_m, -30.0, 40.0, 0.0);
  return motorway.finish();
}

}  // namespace groundgrid::simulation
