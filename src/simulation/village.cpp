// A narrow village street that climbs up to 15 %, between terraces with retaining walls, flights of
// steps and houses. Side streets lead up to a lane above it and down to another below.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

using std::numbers::pi;

constexpr double kVillageLane_m = 1.2;
constexpr double kVillageRoad_m = 2.9;  // Half the width, to the kerb.
constexpr double kWall_m = 4.4;         // The middle of the walls along the street.
constexpr double kWallDepth_m = 0.6;
constexpr double kVillageLot_m = 15.0;
constexpr double kStairs_m = 1.3;  // Their width, at the beginning of a lot.
constexpr double kTread_m = 0.32;
constexpr double kRise_m = 0.17;
constexpr double kGarden_m = 18.5;     // Where the gardens end.
constexpr double kOtherLane_m = 22.0;  // Where the lane above or below begins.
constexpr double kOtherLaneEnd_m = 26.0;
constexpr double kOtherLaneAbove_m = 2.3;
constexpr double kHillside = 0.12;

/// What lies beside a stretch of the street: a garden, or a side street.
struct Lot {
  double first_s = 0.0;
  double above_m = 0.0;  ///< The level of the garden over that of the street at its middle.
  bool stairs = false;
  bool side_street = false;
  [[nodiscard]] double middle() const { return first_s + kVillageLot_m / 2.0; }
};

Lot lot_at(double s, double d, std::uint64_t seed) {
  const double index = std::floor(s / kVillageLot_m);
  Random random(hash({seed, 300, static_cast<std::uint64_t>(static_cast<std::int64_t>(index)),
                      d < 0.0 ? 0U : 1U}));
  Lot lot{.first_s = index * kVillageLot_m, .side_street = random.chance(0.2)};
  // Uphill on the left, downhill on the right.
  lot.above_m = d < 0.0 ? -random.uniform(0.4, 1.7) : random.uniform(0.6, 2.2);
  lot.stairs = !lot.side_street && random.chance(0.5);
  return lot;
}

class Village {
 public:
  Village(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    const double beside = std::abs(at.d);
    const double road = street(at.s) - 0.02 * std::min(beside, kVillageRoad_m);
    const double cobbles = 0.005 * bumps(place, 0.7, seed_);
    if (beside < kVillageRoad_m) return {road + cobbles, label::kRoad, 0.0};
    const double pavement = road + 0.1 * smooth_step(kVillageRoad_m, kVillageRoad_m + 0.08, beside);
    if (beside < kWall_m) return {pavement, label::kSidewalk, 0.0};
    const double lane = street(at.s) + std::copysign(kOtherLaneAbove_m, at.d);
    if (beside > kOtherLane_m) return hillside(at, lane, place);
    const Lot lot = lot_at(at.s, at.d, seed_);
    if (lot.side_street) return side_street(at, lot, pavement, lane);
    if (is_on_stairs(at, lot)) return stairs(pavement, beside, garden(lot));
    const double bank = smooth_step(kGarden_m, kOtherLane_m, beside);
    const double soil = std::lerp(garden(lot), lane, bank) + 0.04 * bumps(place, 2.0, seed_ + 1);
    return {soil, label::kTerrain, 0.1};
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{8.0, {2.0 * pi / 360.0, 0.0}, pi},
            {0.4, {2.0 * pi / 90.0, 0.01}, random.uniform(0.0, 2.0 * pi)}};
  }

  [[nodiscard]] double street(double s) const { return relief_.height(path_->point({s, 0.0})); }

  [[nodiscard]] double garden(const Lot& lot) const { return street(lot.middle()) + lot.above_m; }

  [[nodiscard]] Ground hillside(Station at, double lane, const Eigen::Vector2d& place) const {
    const double beyond = std::max(0.0, std::abs(at.d) - kOtherLaneEnd_m);
    if (!(beyond > 0.0)) return {lane, label::kRoad, 0.0};
    const double rough = bumps(place, 20.0, seed_ + 2) * smooth_step(0.0, 20.0, beyond);
    return {lane + std::copysign(kHillside * beyond, at.d) + rough, label::kTerrain, 0.15};
  }

  static Ground side_street(Station at, const Lot& lot, double foot, double lane) {
    const double share = (std::abs(at.d) - kWall_m) / (kOtherLane_m - kWall_m);
    const bool paved = std::abs(at.s - lot.middle()) < 3.0;
    return {std::lerp(foot, lane, share), paved ? label::kRoad : label::kParking, 0.0};
  }

  static bool is_on_stairs(Station at, const Lot& lot) {
    return lot.stairs && at.s - lot.first_s < kStairs_m;
  }

  static Ground stairs(double foot, double beside, double top) {
    const double steps = kRise_m * (std::floor((beside - kWall_m) / kTread_m) + 1.0);
    return {top > foot ? std::min(foot + steps, top) : std::max(foot - steps, top),
            label::kSidewalk, 0.0};
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

/// A wall from one station to another, `parapet_m` higher than the ground on either side of it.
void build_wall(SceneBuilder& place, Station from, Station to, double parapet_m) {
  constexpr double kPiece_m = 2.5;
  constexpr double kBeside_m = 0.6;
  const double length = std::hypot(to.s - from.s, to.d - from.d);
  const Station ahead{(to.s - from.s) / length, (to.d - from.d) / length};
  const double turn = std::atan2(ahead.d, ahead.s);
  for (const double first : every(kPiece_m, 0.0, length)) {
    const double last = std::min(first + kPiece_m, length);
    const Station start{from.s + first * ahead.s, from.d + first * ahead.d};
    const Station end{from.s + last * ahead.s, from.d + last * ahead.d};
    const double piece = (place.path().point(end) - place.path().point(start)).norm();
    const double base = place.height(start);
    double least = base;
    double most = base;
    for (const double along : {first, last})
      for (const double left : {-kBeside_m, kBeside_m}) {
        const double height = place.height(
            {from.s + along * ahead.s - left * ahead.d, from.d + along * ahead.d + left * ahead.s});
        least = std::min(least, height);
        most = std::max(most, height);
      }
    place.place(make_wall(piece + 0.05, kWallDepth_m, most - base + parapet_m, base - least + 1.0,
                          label::kOtherStructure),
                start, turn);
  }
}

void wall_lot(SceneBuilder& place, const Lot& lot, const Lot& before, double side) {
  const double street = side * kWall_m;
  const double parapet = place.next_random().uniform(0.15, 0.7);
  if (!lot.side_street || !before.side_street)
    build_wall(place, {lot.first_s, street}, {lot.first_s, side * kOtherLane_m}, 0.4);
  if (lot.side_street) return;
  const double from = lot.first_s + (lot.stairs ? kStairs_m : 0.0);
  build_wall(place, {from, street}, {lot.first_s + kVillageLot_m, street}, parapet);
  if (lot.stairs) build_wall(place, {from, street}, {from, side * (kWall_m + 4.5)}, 0.3);
}

void build_house(SceneBuilder& place, const Lot& lot, double side) {
  Random random = place.next_random();
  const double front = side * (kWall_m + random.uniform(2.5, 5.0));
  const double length = random.uniform(9.0, kVillageLot_m - 4.0);
  const double start = lot.first_s + 3.0;
  const double height = random.uniform(5.0, 8.5);
  if (random.chance(0.85))
    place.place(make_building(random, length, 9.0, height),
                {side < 0.0 ? start : start + length, front}, side < 0.0 ? 0.0 : pi);
}

void plant_garden(SceneBuilder& place, const Lot& lot, double side) {
  Random random = place.next_random();
  const auto somewhere = [&](double least, double most) {
    const double s = lot.first_s + random.uniform(2.5, kVillageLot_m - 1.0);
    return Station{s, side * (kWall_m + random.uniform(least, most))};
  };
  for (int i = 0; i < 4; ++i)
    place.place(make_bush(place.next_random(), {0.4, 0.9}, {0.6, 1.8}), somewhere(0.9, 2.2));
  if (random.chance(0.6))
    place.place(make_tree(place.next_random(), {1.2, 2.4}, {1.2, 2.2}, {4.0, 7.0}),
                {lot.first_s + 2.0, side * random.uniform(6.0, 8.0)});
  if (random.chance(0.6))
    place.place(make_hedge(6.0, 0.8, random.uniform(1.0, 1.8)),
                {lot.first_s + 6.0, side * (kWall_m + 0.8)});
  // Climbers and pots in front of the wall.
  for (const double s : every(2.2, kStairs_m + 0.8, kVillageLot_m - 1.0))
    if (random.chance(0.5))
      place.place(make_bush(place.next_random(), {0.25, 0.4}, {0.5, 1.8}),
                  {lot.first_s + s, side * (kWall_m - 0.4)});
}

void furnish_side_street(SceneBuilder& place, const Lot& lot, double side) {
  Random random = place.next_random();
  for (const double s : {2.6, kVillageLot_m - 2.6}) {
    const double turn = random.chance(0.5) ? pi / 2.0 : -pi / 2.0;
    const Station at{lot.first_s + s, side * random.uniform(9.0, 16.0)};
    if (random.chance(0.6))
      place.park(make_car(place.next_random(), label::kCar, place.next_instance()), at, turn);
  }
  place.place(make_tree(place.next_random(), {2.0, 2.6}, {1.5, 2.5}, {6.0, 9.0}),
              {lot.first_s + 2.0, side * 6.2});
}

void add_people(SceneBuilder& place) {
  for (const double s : every(22.0, 12.0, place.path().last())) {
    Random random = place.next_random();
    const double side = random.chance(0.5) ? 1.0 : -1.0;
    place.add_mover(make_person(random, label::kMovingPerson, place.next_instance()),
                    {s, side * (kVillageRoad_m + 0.55)}, random.chance(0.5) ? 1.2 : -1.2);
    place.place(make_pole(5.0, 0.07), {s + 9.0, -side * (kVillageRoad_m + 0.25)});
  }
}

void add_village_traffic(SceneBuilder& place) {
  for (const double s : every(120.0, 70.0, 2.0 * place.path().last())) {
    place.add_mover(
        make_cyclist(place.next_random(), label::kMovingBicyclist, place.next_instance()), {s, 2.5},
        -5.0);
    place.add_mover(make_car(place.next_random(), label::kMovingCar, place.next_instance()),
                    {s + 60.0, 1.3}, -7.0);
  }
}

}  // namespace

Scene make_village(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder place(seed,
                     {{random.uniform(0.12, 0.2), 140.0, random.uniform(0.0, 2.0 * pi)},
                      {0.04, 60.0, random.uniform(0.0, 2.0 * pi)}},
                     length_m);
  place.set_ground(Village(place.shared_path(), seed));
  place.set_lane(-kVillageLane_m);
  const double first_lot = std::ceil(place.path().first() / kVillageLot_m) * kVillageLot_m;
  for (const double side : {-1.0, 1.0})
    for (const double s : every(kVillageLot_m, first_lot, place.path().last() - kVillageLot_m)) {
      const Lot lot = lot_at(s + 1.0, side, seed);
      wall_lot(place, lot, lot_at(s - 1.0, side, seed), side);
      if (lot.side_street) {
        furnish_side_street(place, lot, side);
      } else {
        build_house(place, lot, side);
        plant_garden(place, lot, side);
      }
    }
  add_people(place);
  add_village_traffic(place);
  return place.finish();
}

}  // namespace groundgrid::simulation
