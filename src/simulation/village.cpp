// A narrow village street that climbs up to 15 %, between terraces with retaining walls, flights of
// steps and houses at different levels.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLane_m = 1.2;
constexpr double kRoad_m = 2.9;  // Half the width, to the kerb.
constexpr double kWall_m = 4.4;  // The middle of the walls along the street.
constexpr double kWallDepth_m = 0.6;
constexpr double kLot_m = 15.0;
constexpr double kStairs_m = 1.3;  // Their width, at the beginning of a lot.
constexpr double kTread_m = 0.32;
constexpr double kRise_m = 0.17;
constexpr double kSecondTerrace_m = 20.0;  // Where the next terrace begins, up or down.
constexpr double kSecondStep_m = 2.2;

/// The garden beside a stretch of the street.
struct Lot {
  double middle_s = 0.0;
  double above_m = 0.0;  ///< Its level over that of the street at its middle.
  bool stairs = false;
  bool open = false;  ///< Without a wall: it follows the street.
};

Lot lot_at(double s, double d, std::uint64_t seed) {
  const double index = std::floor(s / kLot_m);
  Random random(hash({seed, 300, static_cast<std::uint64_t>(static_cast<std::int64_t>(index)),
                      d < 0.0 ? 0U : 1U}));
  Lot lot{.middle_s = (index + 0.5) * kLot_m, .open = random.chance(0.2)};
  // Uphill on the left, downhill on the right.
  lot.above_m = d < 0.0 ? -random.uniform(0.6, 2.0) : random.uniform(1.4, 2.8);
  lot.stairs = d > 0.0 && !lot.open && random.chance(0.6);
  return lot;
}

class Village {
 public:
  Village(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const { return at(path_->project(place), place); }

  [[nodiscard]] double street(double s) const { return relief_.height(path_->point({s, 0.0})); }

  [[nodiscard]] double garden(const Lot& lot) const { return street(lot.middle_s) + lot.above_m; }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{8.5, {2.0 * kPi / 360.0, 0.0}, kPi},
            {0.8, {2.0 * kPi / 90.0, 0.01}, random.uniform(0.0, 2.0 * kPi)}};
  }

  [[nodiscard]] Ground at(Station at, const Eigen::Vector2d& place) const {
    const double beside = std::abs(at.d);
    const double street_m = street(at.s) + 0.005 * bumps(place, 0.7, seed_);
    if (beside < kRoad_m) return {street_m - 0.02 * beside, label::kRoad, 0.0};
    const double pavement =
        street_m - 0.02 * kRoad_m + 0.1 * smooth_step(kRoad_m, kRoad_m + 0.08, beside);
    if (beside < kWall_m) return {pavement, label::kSidewalk, 0.0};
    const Lot lot = lot_at(at.s, at.d, seed_);
    if (lot.open) return {pavement, label::kParking, 0.0};
    if (lot.stairs && is_on_stairs(at, lot)) return stairs(pavement, beside, garden(lot));
    const double second =
        beside > kSecondTerrace_m ? (at.d > 0.0 ? kSecondStep_m : -kSecondStep_m) : 0.0;
    const double soil = garden(lot) + second + 0.04 * bumps(place, 2.0, seed_ + 1);
    return {soil, label::kTerrain, 0.1};
  }

  static bool is_on_stairs(Station at, const Lot& lot) {
    return at.s - (lot.middle_s - kLot_m / 2.0) < kStairs_m;
  }

  static Ground stairs(double foot, double beside, double top) {
    const double step = std::floor((beside - kWall_m) / kTread_m) + 1.0;
    return {std::min(foot + kRise_m * step, std::max(foot, top)), label::kSidewalk, 0.0};
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

/// Walls along the street and between two lots hide the steps of the terrain.
void wall_lot(SceneBuilder& place, const Village& village, const Lot& lot, const Lot& before,
              double side) {
  const double first = lot.middle_s - kLot_m / 2.0;
  const double from = lot.stairs ? first + kStairs_m : first;
  const double street = village.street(lot.middle_s);
  constexpr double kPiece_m = 2.5;
  Random random = place.next_random();
  const double parapet = random.uniform(0.15, 0.9);
  for (double s = from; s < first + kLot_m; s += kPiece_m) {
    const double length = std::min(kPiece_m, first + kLot_m - s);
    const Station start{s, side * kWall_m};
    const double base = place.height(start);
    const double top = std::max(village.garden(lot), village.street(s + length)) + parapet;
    place.place(make_wall(length + 0.02, kWallDepth_m, top - base, base - street + 6.0,
                          label::kOtherStructure),
                start);
  }
  const Station corner{first, side * (kWall_m - kWallDepth_m / 2.0)};
  const double base = place.height(corner);
  const double top = std::max({village.garden(lot), village.street(first), village.garden(before)});
  place.place(make_wall(16.0, kWallDepth_m, std::max(top - base, 0.3) + 0.4, 6.0, label::kFence),
              corner, side * kPi / 2.0);
  place.place(make_wall(kLot_m, kWallDepth_m, side > 0.0 ? kSecondStep_m + 0.3 : 0.3, 5.0,
                        label::kOtherStructure),
              {first, side * kSecondTerrace_m});
  if (lot.stairs)
    place.place(make_wall(5.0, 0.3, village.garden(lot) - base + 0.4, 6.0, label::kOtherStructure),
                {first + kStairs_m + 0.1, side * (kWall_m - 0.2)}, side * kPi / 2.0);
}

void build_lot(SceneBuilder& place, const Lot& lot, double side) {
  Random random = place.next_random();
  const double first = lot.middle_s - kLot_m / 2.0;
  const double front = side * (kWall_m + random.uniform(2.5, 5.0));
  const double length = random.uniform(9.0, kLot_m - 4.0);
  const double start = first + 3.0;
  if (random.chance(0.85))
    place.place(make_building(random, length, 9.0, random.uniform(5.0, 8.5)),
                {side < 0.0 ? start : start + length, front}, side < 0.0 ? 0.0 : kPi);
  for (int i = 0; i < 2; ++i)
    place.place(make_bush(place.next_random(), random.uniform(0.4, 0.9), random.uniform(0.6, 1.5)),
                {first + random.uniform(2.5, kLot_m - 1.0), side * random.uniform(5.6, 6.5)});
  if (random.chance(0.4))
    place.place(make_tree(place.next_random(), random.uniform(1.2, 2.4), random.uniform(1.2, 2.2),
                          random.uniform(4.0, 7.0)),
                {first + 1.8, side * random.uniform(6.5, 9.0)});
  if (lot.open)
    place.place(make_car(place.next_random(), label::kCar, place.next_instance()),
                {first + 5.0, side * (kWall_m + 1.2)}, random.chance(0.5) ? 0.0 : kPi);
}

void add_people(SceneBuilder& place) {
  for (double s = 12.0; s < place.path().last(); s += 22.0) {
    Random random = place.next_random();
    const double d = (random.chance(0.5) ? 1.0 : -1.0) * (kRoad_m + 0.6);
    place.add_mover(make_person(random, label::kMovingPerson, place.next_instance()), {s, d},
                    random.chance(0.5) ? 1.2 : -1.2);
    place.place(make_pole(5.0, 0.07), {s + 9.0, -d});
  }
  place.add_mover(make_cyclist(place.next_random(), label::kMovingBicyclist, place.next_instance()),
                  {70.0, 1.8}, -5.0);
  place.add_mover(make_car(place.next_random(), label::kMovingCar, place.next_instance()),
                  {130.0, 1.4}, -7.0);
}

}  // namespace

Scene make_village(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder place(seed,
                     {{random.uniform(0.12, 0.2), 140.0, random.uniform(0.0, 2.0 * kPi)},
                      {0.04, 60.0, random.uniform(0.0, 2.0 * kPi)}},
                     length_m);
  const Village village(place.shared_path(), seed);
  place.set_ground(village);
  place.set_lane(-kLane_m);
  for (const double side : {-1.0, 1.0})
    for (double s = std::ceil(place.path().first() / kLot_m) * kLot_m;
         s + kLot_m < place.path().last(); s += kLot_m) {
      const Lot lot = lot_at(s + 1.0, side, seed);
      if (!lot.open) wall_lot(place, village, lot, lot_at(s - 1.0, side, seed), side);
      build_lot(place, lot, side);
    }
  add_people(place);
  return place.finish();
}

}  // namespace groundgrid::simulation
