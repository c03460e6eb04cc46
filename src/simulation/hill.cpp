// A winding road through a wood on a hillside: it climbs more than 20 m in its first 250 m, lies on
// embankments, and in cuttings with ditches, between trees and undergrowth.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

using std::numbers::pi;

constexpr double kHillLane_m = 1.3;
constexpr double kHillRoad_m = 2.7;  // Half the width.
constexpr double kGravel_m = 3.6;    // Where the gravel beside the road ends and the slope begins.
constexpr double kCrown = 0.025;     // The fall of the road to its sides.
constexpr Earthwork kEarthwork{.gradient = 0.4, .ditch_m = 0.22, .bottom_m = 0.4};

class Hillside {
 public:
  Hillside(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double edge =
        relief_.height(path_->point({at.s, 0.0})) - kCrown * std::min(beside, kGravel_m);
    if (beside < kHillRoad_m) return {edge, label::kRoad, 0.0};
    if (beside < kGravel_m) return {edge, label::kOtherGround, 0.0};
    const double beyond = beside - kGravel_m;
    const double slope = beside_road(beyond, wild(place) - edge, kEarthwork);
    const double floor = 0.06 * bumps(place, 1.3, seed_ + 2);
    const double grass = 0.12 + 0.1 * bumps(place, 4.0, seed_ + 3);
    const double share = smooth_step(0.0, 1.5, beyond);
    return {edge + slope + share * floor, label::kTerrain, share * grass};
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{11.3, {2.0 * pi / 500.0, 0.0}, pi},
            {1.8, {0.006, 2.0 * pi / 130.0}, random.uniform(0.0, 2.0 * pi)},
            {0.8, {0.07, 0.05}, random.uniform(0.0, 2.0 * pi)}};
  }

  [[nodiscard]] double wild(const Eigen::Vector2d& place) const {
    return relief_.height(place) - 0.35 + 1.2 * bumps(place, 17.0, seed_) +
           0.25 * bumps(place, 5.0, seed_ + 1);
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

void plant_wood(SceneBuilder& wood, double s, double side) {
  Random random = wood.next_random();
  const auto somewhere = [&](double least, double most) {
    return somewhere_beside(random, s, 3.0, side, {least, most});
  };
  if (random.chance(0.6))
    wood.place(make_tree(wood.next_random(), {1.5, 4.0}, {1.5, 3.2}, {7.0, 14.0}),
               somewhere(6.3, 14.0));
  if (random.chance(0.5))
    wood.place(make_tree(wood.next_random(), {1.0, 4.0}, {1.5, 3.2}, {7.0, 14.0}),
               somewhere(14.0, 45.0));
  for (int i = 0; i < 2; ++i)
    wood.place(make_conifer(wood.next_random(), {0.3, 2.5}, {1.3, 2.6}, {9.0, 18.0}),
               somewhere(11.0, 50.0));
  for (int i = 0; i < 2; ++i)
    wood.place(make_bush(wood.next_random(), {0.3, 1.2}, {0.4, 1.7}), somewhere(5.2, 12.0));
  for (int i = 0; i < 2; ++i)
    wood.place(make_bush(wood.next_random(), {0.5, 1.5}, {0.5, 2.0}), somewhere(10.0, 35.0));
  if (random.chance(0.06)) wood.place(make_rock(wood.next_random()), somewhere(6.0, 12.0));
}

}  // namespace

Scene make_hill(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder wood(seed,
                    {{random.uniform(0.35, 0.45), 170.0, random.uniform(-0.3, 0.3)},
                     {random.uniform(0.08, 0.14), 70.0, random.uniform(-0.3, 0.3)}},
                    length_m);
  wood.set_ground(Hillside(wood.shared_path(), seed));
  wood.set_lane(-kHillLane_m);
  for (const double side : {-1.0, 1.0}) {
    for (const double s : every(3.0, wood.path().first(), wood.path().last()))
      plant_wood(wood, s, side);
    for (const double s : every(25.0, wood.path().first(), wood.path().last()))
      wood.place(make_pole(1.0, 0.06), {s, side * 3.2});
  }
  double s = 90.0;
  while (s < 2.0 * wood.path().last()) {
    wood.add_mover(make_car(wood.next_random(), label::kMovingCar, wood.next_instance()),
                   {s, kHillLane_m}, -9.0);
    s += random.uniform(80.0, 200.0);
  }
  return wood.finish();
}

}  // namespace groundgrid::simulation
