// A street in a town: crowned road with parking strips, kerbs that are lowered at drives, raised
// pavements, front gardens on many levels, side streets at T-junctions with a planted median before
// each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"
#include "simulation/urban_houses.hpp"
#include "simulation/urban_street.hpp"

namespace groundgrid::simulation {
namespace {

using namespace urban;

using std::numbers::pi;

Bend bend(Random& random, double least, double most, double length_m) {
  const double amplitude = random.uniform(least, most);
  return {amplitude, length_m, random.uniform(0.0, 2.0 * pi)};
}

void park_cars(SceneBuilder& town, const Street& street, double side) {
  double s = town.path().first() + 8.0;
  while (s < town.path().last()) {
    Random random = town.next_random();
    s += random.uniform(5.0, 6.4);
    const double d = side * (kLanesEdge_m + random.uniform(0.95, 1.15));
    if (!street.has_parking(s - 3.0, d) || !street.has_parking(s + 3.0, d)) continue;
    if (random.chance(0.3)) continue;
    const double turn = (side < 0.0 ? 0.0 : pi) + random.uniform(-0.03, 0.03);
    const bool lorry = random.chance(0.03);
    if (lorry) s += 4.0;
    const std::uint16_t instance = town.next_instance();
    town.place(lorry ? make_lorry(random, label::kTruck, instance)
                     : make_car(random, label::kCar, instance),
               {s, d}, turn);
    if (lorry) s += 3.0;
  }
}

void plant_street_tree(SceneBuilder& town, Station at) {
  Random random = town.next_random();
  const double clearance = random.uniform(1.5, 2.6);
  const double radius = random.uniform(2.0, 3.6);
  const double height = random.uniform(5.5, 10.0);
  town.place(make_tree(random, clearance, radius, height), at);
}

void stand_person(SceneBuilder& town, Station at) {
  const Random random = town.next_random();
  town.place(make_person(random, label::kPerson, town.next_instance()), at);
}

void walk_person(SceneBuilder& town, double s, double side) {
  Random random = town.next_random();
  const double d = side * (kKerb_m + random.uniform(0.9, 2.0));
  const double speed = random.chance(0.5) ? 1.3 : -1.4;
  town.add_mover(make_person(random, label::kMovingPerson, town.next_instance()), {s, d}, speed);
}

/// Posts, planters and boxes: what stands on a pavement and is no higher than a table.
void place_low_furniture(SceneBuilder& town, double s, double side) {
  Random random = town.next_random();
  const double by_kerb = side * (kKerb_m + 0.35);
  const double kind = random.uniform();
  if (kind < 0.4) {
    for (int i = 0; i < 4; ++i) town.place(make_pole(0.85, 0.06), {s + 1.3 * i, by_kerb});
  } else if (kind < 0.75) {
    const double length = random.uniform(0.8, 1.8);
    town.place(make_planter(length, random.uniform(0.35, 0.5)), {s, by_kerb + 0.2 * side});
  } else {
    const double length = random.uniform(0.6, 1.2);
    town.place(make_wall(length, 0.35, random.uniform(0.7, 1.2), 0.2, label::kOtherObject),
               {s, side * (kGardens_m - 0.25)});
  }
}

void furnish_pavement(SceneBuilder& town, double side) {
  for (const double s : every(5.0, town.path().first(), town.path().last())) {
    Random random = town.next_random();
    const double at = s + random.uniform(0.0, 3.5);
    if (is_near_junction(at, 7.0)) continue;
    const double by_kerb = side * (kKerb_m + 0.5);
    const double by_garden = side * (kGardens_m - 0.4);
    const double kind = random.uniform();
    if (kind < 0.36)
      plant_street_tree(town, {at, by_kerb});
    else if (kind < 0.45)
      town.place(make_pole(random.uniform(4.5, 7.0), 0.08), {at, by_kerb});
    else if (kind < 0.52)
      town.place(make_sign(random), {at, by_kerb});
    else if (kind < 0.58)
      town.place(make_bin(random), {at, by_garden}, 3.0 * kind);
    else if (kind < 0.62)
      stand_person(town, {at, by_garden});
    else if (kind < 0.7)
      walk_person(town, at, side);
    else if (kind < 0.85)
      place_low_furniture(town, at, side);
  }
}

void line_side_street(SceneBuilder& town, const Junction& junction) {
  for (const double turn : {-1.0, 1.0}) {
    const double beside = junction.s + turn * (kSideStreet_m + kPavement_m + 0.4);
    town.place(make_hedge(30.0, 0.7, 1.5), {beside, junction.side * 14.0},
               junction.side * pi / 2.0);
    Random random = town.next_random();
    town.place(make_sign(random),
               {junction.s + turn * (kSideStreet_m + 0.5), junction.side * (kKerb_m + 1.0)});
    const double car = random.uniform(20.0, 40.0);
    town.place(make_car(random, label::kCar, town.next_instance()),
               {junction.s - turn * 1.9, junction.side * car}, junction.side * pi / 2.0);
    const bool inward = turn * junction.side < 0.0;
    town.place(make_building(random, 13.0, 10.0, 9.0),
               {junction.s + turn * 10.0, junction.side * (inward ? 33.0 : 20.0)},
               (inward ? -junction.side : junction.side) * pi / 2.0);
  }
}

void plant_median(SceneBuilder& town, const Junction& junction) {
  for (const double before : every(2.0, 10.0, 26.0)) {
    Random random = town.next_random();
    town.place(make_bush(random, 0.4, random.uniform(0.3, 0.8)), {junction.s - before, 0.0});
  }
  town.place(make_tree(town.next_random(), 2.3, 1.6, 6.0), {junction.s - 18.0, 0.0});
}

void add_traffic(SceneBuilder& town) {
  Random random = town.next_random();
  town.add_mover(make_car(random, label::kMovingCar, town.next_instance()), {24.0, -kLane_m}, 10.0);
  town.add_mover(make_cyclist(random, label::kMovingBicyclist, town.next_instance()),
                 {35.0, -kLanesEdge_m + 0.3}, 4.5);
  double s = 70.0;
  while (s < 2.0 * town.path().last()) {
    const bool lorry = random.chance(0.08);
    const std::uint16_t instance = town.next_instance();
    const Random next = town.next_random();
    town.add_mover(lorry ? make_lorry(next, label::kMovingTruck, instance)
                         : make_car(next, label::kMovingCar, instance),
                   {s, kLane_m}, -9.0);
    s += random.uniform(60.0, 180.0);
  }
}

}  // namespace

Scene make_urban(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder town(seed, {bend(random, 0.06, 0.12, 260.0), bend(random, 0.03, 0.03, 110.0)},
                    length_m);
  const Street street(town.shared_path(), seed);
  town.set_ground(street);
  town.set_lane(-kLane_m);
  for (const double side : {-1.0, 1.0}) {
    park_cars(town, street, side);
    furnish_pavement(town, side);
    const double first_lot = std::floor(town.path().first() / kLot_m) * kLot_m;
    for (const double lot : every(kLot_m, first_lot, town.path().last()))
      build_lot(town, street, lot, side);
  }
  const double first_junction = junction_near(town.path().first() + kBetweenJunctions_m / 2.0).s;
  for (const double s : every(kBetweenJunctions_m, first_junction, town.path().last())) {
    line_side_street(town, junction_near(s));
    plant_median(town, junction_near(s));
  }
  add_traffic(town);
  return town.finish();
}

}  // namespace groundgrid::simulation
