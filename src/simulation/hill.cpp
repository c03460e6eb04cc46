// A winding road through a wood on a hillside: it climbs more than 20 m in its first 250 m, lies on
// embankments and in cuttings with a ditch on each side, between trees and undergrowth.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLane_m = 1.3;
constexpr double kRoad_m = 2.7;      // Half the width.
constexpr double kShoulder_m = 3.4;  // Where the gravel beside the road ends.
constexpr double kDitch_m = 4.5;     // Its middle.

class Hillside {
 public:
  Hillside(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double road = relief_.height(path_->point({at.s, 0.0})) + profile(beside);
    const double wild = relief_.height(place) + 1.3 * bumps(place, 17.0, seed_) +
                        0.25 * bumps(place, 5.0, seed_ + 1);
    const double floor = 0.07 * bumps(place, 1.3, seed_ + 2) * smooth_step(3.4, 5.0, beside);
    const double share = smooth_step(5.5, 12.0, beside);
    return cover(beside, place, (1.0 - share) * road + share * wild + floor);
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{12.0, {2.0 * kPi / 500.0, 0.0}, kPi},
            {4.5, {0.006, 2.0 * kPi / 130.0}, random.uniform(0.0, 2.0 * kPi)},
            {0.8, {0.07, 0.05}, random.uniform(0.0, 2.0 * kPi)}};
  }

  static double profile(double beside) {
    const double crown = -0.025 * std::min(beside, kShoulder_m);
    const double in_ditch = (beside - kDitch_m) / (kDitch_m - kShoulder_m);
    return crown - 0.5 * std::max(0.0, 1.0 - in_ditch * in_ditch);
  }

  [[nodiscard]] Ground cover(double beside, const Eigen::Vector2d& place, double height) const {
    if (beside < kRoad_m) return {height, label::kRoad, 0.0};
    if (beside < kShoulder_m) return {height, label::kOtherGround, 0.0};
    const double grass = 0.12 + 0.1 * bumps(place, 4.0, seed_ + 3);
    return {height, label::kTerrain, grass * smooth_step(kShoulder_m, kDitch_m, beside)};
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

void plant_wood(SceneBuilder& wood, double s, double side) {
  Random random = wood.next_random();
  const double near = side * random.uniform(6.3, 14.0);
  const double far = side * random.uniform(14.0, 45.0);
  const double at = s + random.uniform(0.0, 3.0);
  if (random.chance(0.45))
    wood.place(make_tree(random, random.uniform(1.5, 4.0), random.uniform(1.5, 3.2),
                         random.uniform(7.0, 14.0)),
               {at, near}, random.uniform(0.0, 6.0));
  if (random.chance(0.8))
    wood.place(make_conifer(wood.next_random(), random.uniform(0.8, 3.5), random.uniform(1.3, 2.6),
                            random.uniform(9.0, 18.0)),
               {at + 1.0, far});
  if (random.chance(0.75))
    wood.place(make_bush(wood.next_random(), random.uniform(0.3, 1.2), random.uniform(0.4, 1.7)),
               {at + 0.7, side * random.uniform(5.6, 9.0)});
  if (random.chance(0.6))
    wood.place(make_bush(wood.next_random(), random.uniform(0.5, 1.5), random.uniform(0.5, 1.5)),
               {at + 2.1, side * random.uniform(8.0, 25.0)});
  if (random.chance(0.06))
    wood.place(make_rock(wood.next_random()), {at, side * random.uniform(6.0, 12.0)});
}

}  // namespace

Scene make_hill(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder wood(seed,
                    {{random.uniform(0.35, 0.45), 170.0, random.uniform(-0.3, 0.3)},
                     {random.uniform(0.08, 0.14), 70.0, random.uniform(-0.3, 0.3)}},
                    length_m);
  wood.set_ground(Hillside(wood.shared_path(), seed));
  wood.set_lane(-kLane_m);
  for (const double side : {-1.0, 1.0}) {
    for (double s = wood.path().first(); s < wood.path().last(); s += 3.0)
      plant_wood(wood, s, side);
    for (double s = wood.path().first(); s < wood.path().last(); s += 25.0)
      wood.place(make_pole(1.0, 0.06), {s, side * 3.2});
  }
  for (double s = 90.0; s < 2.0 * wood.path().last(); s += random.uniform(80.0, 200.0))
    wood.add_mover(make_car(wood.next_random(), label::kMovingCar, wood.next_instance()),
                   {s, kLane_m}, -9.0);
  return wood.finish();
}

}  // namespace groundgrid::simulation
