// A motorway with guard rails, through higher and lower land: slopes of 30 to 40 % down to the
// land, or ditches as steep and slopes up from them. Lorries, and bridges over it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

using std::numbers::pi;

constexpr double kMedian_m = 1.6;    // Half its width.
constexpr double kShoulder_m = 9.3;  // Where the hard shoulder begins.
constexpr double kAsphalt_m = 12.0;
constexpr double kVerge_m = 14.0;  // Where the slope begins.
constexpr double kFall = 0.02;     // Of the road to its sides.
constexpr double kDamGradient = 0.5;
constexpr double kRightLane_m = 7.4;
constexpr double kLeftLane_m = 3.6;
constexpr double kBetweenBridges_m = 260.0;
constexpr double kFirstBridge_m = 90.0;
constexpr double kHalfBridge_m = 4.5;  // Half the width of the road on it.
constexpr double kDeck_m = 6.0;        // Its height.

double nearest_bridge(double s) {
  return kFirstBridge_m + kBetweenBridges_m * std::round((s - kFirstBridge_m) / kBetweenBridges_m);
}

class Motorway {
 public:
  Motorway(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double road = level(at.s) - kFall * std::clamp(beside - kMedian_m, 0.0, kVerge_m);
    const double beyond = std::max(0.0, beside - kVerge_m);
    const double slope = beside_road(beyond, land(at, place) - road, earthwork(at));
    return cover(at, beside, road + slope + roughness(place, beside));
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    return {{4.0, {2.0 * pi / 700.0, 0.0}, Random(hash({seed, 100})).uniform(0.0, 2.0 * pi)}};
  }

  [[nodiscard]] double level(double s) const { return relief_.height(path_->point({s, 0.0})); }

  [[nodiscard]] double roughness(const Eigen::Vector2d& place, double beside) const {
    return 0.03 * bumps(place, 1.5, seed_) * smooth_step(kAsphalt_m, kVerge_m, beside);
  }

  /// Fields, and the dams of the roads that cross.
  [[nodiscard]] double land(Station at, const Eigen::Vector2d& place) const {
    const double fields = relief_.height(place) - 1.6 + 2.5 * bumps(place, 90.0, seed_ + 1);
    const double bridge_s = nearest_bridge(at.s);
    const double beyond_dam = std::max(0.0, std::abs(at.s - bridge_s) - kHalfBridge_m);
    return std::max(fields, level(bridge_s) + kDeck_m - kDamGradient * beyond_dam);
  }

  static Earthwork earthwork(Station at) {
    const double turn = 2.0 * pi * at.s / 150.0 + (at.d < 0.0 ? 0.0 : 2.0);
    return {.gradient = 0.35 + 0.05 * std::sin(turn), .ditch_m = 0.4, .bottom_m = 0.5};
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
    return {height, label::kTerrain, beside < kVerge_m ? 0.08 : 0.15};
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
  constexpr double kPiece_m = 4.0;  // They overlap, for bends.
  for (const double s : every(kPiece_m, motorway.path().first(), motorway.path().last()))
    for (const double d : {-kAsphalt_m - 0.8, -0.9, 0.9, kAsphalt_m + 0.8})
      motorway.place(guard_rail(kPiece_m + 0.15), {s, d});
}

Mesh bridge() {
  Mesh mesh;
  const std::uint32_t concrete =
      mesh.add_surface({.label = label::kOtherStructure, .reflectivity = 0.35F});
  constexpr double kHalfLength_m = 36.0;
  add_box(mesh, {-kHalfBridge_m, -kHalfLength_m, kDeck_m - 1.1},
          {kHalfBridge_m, kHalfLength_m, kDeck_m}, concrete);
  for (const double x : {-kHalfBridge_m, kHalfBridge_m})
    add_box(mesh, {x - 0.1, -kHalfLength_m, kDeck_m}, {x + 0.1, kHalfLength_m, kDeck_m + 1.0},
            concrete);
  for (const double y : {-14.5, 0.0, 14.5})
    for (const double x : {-3.0, 0.0, 3.0})
      add_cylinder(mesh, {x, y, -2.0}, 0.45, 0.45, kDeck_m + 1.0, 12, concrete);
  return mesh;
}

void add_traffic(SceneBuilder& motorway, double lane_m, double speed_mps, double from_m,
                 double lorries) {
  Random random = motorway.next_random();
  const double last = motorway.path().last() * 3.0;
  double s = from_m;
  while (s < last) {
    const std::uint16_t instance = motorway.next_instance();
    const Random next = motorway.next_random();
    motorway.add_mover(random.chance(lorries) ? make_lorry(next, label::kMovingTruck, instance)
                                              : make_car(next, label::kMovingCar, instance),
                       {s, lane_m}, speed_mps);
    s += random.uniform(35.0, 80.0);
  }
}

void plant_slopes(SceneBuilder& motorway) {
  constexpr double kClear_m = 10.0;
  for (const double s : every(5.0, motorway.path().first(), motorway.path().last()))
    for (const double side : {-1.0, 1.0}) {
      Random random = motorway.next_random();
      const double along = s + random.uniform(0.0, 5.0);
      if (std::abs(along - nearest_bridge(along)) < kClear_m) continue;
      if (random.chance(0.6))
        motorway.place(make_bush(motorway.next_random(), {0.6, 1.6}, {0.8, 2.2}),
                       {along, side * random.uniform(17.0, 30.0)});
      if (random.chance(0.35))
        motorway.place(make_tree(motorway.next_random(), {1.0, 2.5}, {1.5, 3.0}, {5.0, 10.0}),
                       {along + 2.0, side * random.uniform(21.0, 40.0)});
    }
}

}  // namespace

Scene make_motorway(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder motorway(seed, {{random.uniform(0.05, 0.1), 500.0, random.uniform(0.0, 2.0 * pi)}},
                        length_m);
  motorway.set_ground(Motorway(motorway.shared_path(), seed));
  motorway.set_lane(-kRightLane_m);
  add_rails(motorway);
  plant_slopes(motorway);
  for (const double s : every(kBetweenBridges_m, kFirstBridge_m, motorway.path().last()))
    motorway.place(bridge(), {s, 0.0});
  for (const double s : every(110.0, 30.0, motorway.path().last())) {
    motorway.place(make_sign(motorway.next_random()), {s, -kAsphalt_m - 1.4});
    motorway.place(make_pole(9.0, 0.12), {s + 40.0, -kAsphalt_m - 1.6});
  }
  add_traffic(motorway, -kRightLane_m, 20.0, 45.0, 0.5);
  // Faster than the own vehicle: those who overtake it late begin far behind.
  add_traffic(motorway, -kLeftLane_m, 26.0, -90.0 - 0.3 * length_m, 0.0);
  add_traffic(motorway, kRightLane_m, -22.0, 20.0, 0.5);
  add_traffic(motorway, kLeftLane_m, -30.0, 40.0, 0.0);
  return motorway.finish();
}

}  // namespace groundgrid::simulation
