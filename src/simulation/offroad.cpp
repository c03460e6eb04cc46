// A track across rolling fields: furrows, grass of varying height, rocks, bushes and few trees.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

using std::numbers::pi;

constexpr double kTrack_m = 1.3;  // Half its width.

class Fields {
 public:
  Fields(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double wild = smooth_step(kTrack_m, 2.4, beside);
    const double rut = (beside - 0.75) / 0.3;
    const double height = relief_.height(place) + 0.15 * bumps(place, 5.0, seed_) +
                          wild * (furrows(place) + 0.06 * bumps(place, 1.1, seed_ + 1)) -
                          0.08 * std::exp(-rut * rut);
    if (beside < kTrack_m) return {height, label::kOtherGround, 0.0};
    const double grass = 0.16 + 0.15 * bumps(place, 9.0, seed_ + 2);
    return {height, label::kTerrain, wild * std::max(grass, 0.02)};
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{1.8, {0.055, 0.02}, random.uniform(0.0, 2.0 * pi)},
            {1.2, {-0.03, 0.08}, random.uniform(0.0, 2.0 * pi)},
            {0.2, {0.21, 0.13}, random.uniform(0.0, 2.0 * pi)}};
  }

  /// Every second field is ploughed.
  [[nodiscard]] double furrows(const Eigen::Vector2d& place) const {
    const double field = smooth_step(-0.1, 0.1, bumps(place, 45.0, seed_ + 3));
    return 0.09 * field * std::sin(2.0 * pi * (0.3 * place.x() + 0.95 * place.y()) / 0.9);
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

void scatter(SceneBuilder& fields, double s, double side) {
  Random random = fields.next_random();
  const auto somewhere = [&](double least, double most) {
    return somewhere_beside(random, s, 5.0, side, {least, most});
  };
  if (random.chance(0.45)) {
    const double turn = random.uniform(0.0, 6.0);
    fields.place(make_rock(fields.next_random()), somewhere(3.0, 22.0), turn);
  }
  if (random.chance(0.6))
    fields.place(make_bush(fields.next_random(), {0.4, 1.6}, {0.5, 2.0}), somewhere(4.0, 35.0));
  if (random.chance(0.3))
    fields.place(make_tree(fields.next_random(), {1.2, 2.5}, {1.6, 3.2}, {5.0, 10.0}),
                 somewhere(6.0, 50.0));
  if (random.chance(0.12)) fields.place(make_pole(1.3, 0.06), {s, side * 3.4});
}

}  // namespace

Scene make_offroad(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder fields(seed,
                      {{random.uniform(0.2, 0.35), 140.0, random.uniform(0.0, 2.0 * pi)},
                       {0.08, 50.0, random.uniform(0.0, 2.0 * pi)}},
                      length_m);
  fields.set_ground(Fields(fields.shared_path(), seed));
  for (const double side : {-1.0, 1.0})
    for (const double s : every(5.0, fields.path().first(), fields.path().last()))
      scatter(fields, s, side);
  for (const double s : every(150.0, 30.0, fields.path().last()))
    fields.add_mover(
        make_person(fields.next_random(), label::kMovingPerson, fields.next_instance()), {s, 2.2},
        1.2);
  return fields.finish();
}

}  // namespace groundgrid::simulation
