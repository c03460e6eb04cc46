// A street in a town: crowned road with parking strips, kerbs that are lowered at drives, raised
// pavements, gardens, side streets at T-junctions with a planted median before each.
#include <algorithm>
#include <cmath>
#include <numbers>

#include "simulation/relief.hpp"
#include "simulation/scene_builder.hpp"
#include "simulation/scenes.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kLane_m = 1.5;        // From the middle of the road.
constexpr double kLanesEdge_m = 2.85;  // Where the parking strips begin.
constexpr double kKerb_m = 4.9;
constexpr double kPavement_m = 2.3;
constexpr double kSideStreet_m = 3.0;  // Half its width.
constexpr double kFirstJunction_m = 55.0;
constexpr double kBetweenJunctions_m = 95.0;
constexpr double kLot_m = 19.0;

std::uint64_t number(double value) {
  return static_cast<std::uint64_t>(static_cast<std::int64_t>(std::floor(value)));
}

/// The junction nearest to s: where it is, and on which side its street leaves.
struct Junction {
  double s;
  double side;
};

Junction junction_near(double s) {
  const double index = std::round((s - kFirstJunction_m) / kBetweenJunctions_m);
  return {kFirstJunction_m + index * kBetweenJunctions_m,
          std::fmod(std::abs(index), 2.0) < 0.5 ? 1.0 : -1.0};
}

bool is_near_junction(double s, double reach_m) {
  return std::abs(s - junction_near(s).s) < reach_m;
}

class Street {
 public:
  Street(std::shared_ptr<const Path> path, std::uint64_t seed)
      : path_(std::move(path)), seed_(seed), relief_(waves(seed)) {}

  Ground operator()(const Eigen::Vector2d& place) const {
    const Station at = path_->project(place);
    Ground ground = across(at);
    ground.height_m += relief_.height(place) + 0.004 * bumps(place, 0.8, seed_);
    return ground;
  }

  [[nodiscard]] bool has_parking(double s, double d) const {
    return !is_near_junction(s, 20.0) && draw(1, s / 40.0, d) < 0.65;
  }

 private:
  static std::vector<Wave> waves(std::uint64_t seed) {
    Random random(hash({seed, 100}));
    return {{1.2, {2.0 * kPi / 170.0, 0.004}, random.uniform(0.0, 2.0 * kPi)},
            {0.4, {0.03, 2.0 * kPi / 120.0}, random.uniform(0.0, 2.0 * kPi)}};
  }

  /// One number for each stretch of each side.
  [[nodiscard]] double draw(std::uint64_t what, double stretch, double d) const {
    return Random(hash({seed_, 200 + what, number(stretch), d < 0.0 ? 0U : 1U})).uniform();
  }

  [[nodiscard]] Ground across(Station at) const {
    const Junction junction = junction_near(at.s);
    const bool beside = at.d * junction.side > 0.0;
    const double from_street = std::abs(at.s - junction.s) - kSideStreet_m;
    const double beyond_kerb = std::abs(at.d) - kKerb_m;
    const double outside = beside ? std::min(beyond_kerb, from_street) : beyond_kerb;
    if (outside < 0.0) return road(at, junction, std::max(beyond_kerb, 0.0));
    return beside_road(at, junction, outside, beyond_kerb);
  }

  [[nodiscard]] static double crown(double d) { return -0.02 * std::min(std::abs(d), kKerb_m); }

  [[nodiscard]] Ground road(Station at, const Junction& junction, double into_street) const {
    const double before = junction.s - at.s;
    if (before > 8.0 && before < 27.0 && std::abs(at.d) < 0.45)
      return {crown(at.d) + 0.13, label::kTerrain, 0.05};
    const double own_crown = -0.015 * std::abs(at.s - junction.s);
    const double height =
        crown(at.d) + smooth_step(0.0, 4.0, into_street) * own_crown + 0.01 * into_street;
    return {height, road_label(at, into_street), 0.0};
  }

  [[nodiscard]] std::uint16_t road_label(Station at, double into_street) const {
    if (into_street > 0.0) return label::kRoad;
    if (std::abs(at.d) < 0.06 && std::fmod(at.s + 1200.0, 9.0) < 4.0) return label::kLaneMarking;
    if (std::abs(at.d) > kLanesEdge_m && has_parking(at.s, at.d)) return label::kParking;
    return label::kRoad;
  }

  [[nodiscard]] double kerb(Station at, const Junction& junction) const {
    const double full = 0.08 + 0.07 * draw(2, at.s / 60.0, at.d);
    const double drive = (std::floor(at.s / kLot_m) + 0.15) * kLot_m;
    const double at_drive = 1.0 - smooth_step(1.6, 2.6, std::abs(at.s - drive));
    const double at_crossing = 1.0 - smooth_step(5.0, 6.5, std::abs(at.s - junction.s));
    return full - (full - 0.025) * std::max(at_drive, at_crossing);
  }

  [[nodiscard]] Ground beside_road(Station at, const Junction& junction, double outside,
                                   double beyond_kerb) const {
    const double edge = crown(at.d) + 0.01 * std::max(beyond_kerb, 0.0);
    const double height = edge + kerb(at, junction) * smooth_step(0.0, 0.08, outside) +
                          0.02 * std::min(outside, kPavement_m);
    if (outside < kPavement_m) return {height, label::kSidewalk, 0.0};
    const double garden = 0.025 * std::min(outside - kPavement_m, 12.0);
    const double kind = draw(3, at.s / kLot_m, at.d);
    if (kind < 0.25) return {height + garden, label::kOtherGround, 0.0};
    if (kind < 0.45) return {height + garden, label::kSidewalk, 0.0};
    return {height + garden, label::kTerrain, 0.04 + 0.08 * kind};
  }

  std::shared_ptr<const Path> path_;
  std::uint64_t seed_;
  Relief relief_;
};

void park_cars(SceneBuilder& town, const Street& street, double side) {
  for (double s = town.path().first() + 8.0; s < town.path().last();) {
    Random random = town.next_random();
    s += random.uniform(5.2, 7.0);
    const double d = side * (kLanesEdge_m + random.uniform(0.95, 1.15));
    if (!street.has_parking(s - 3.0, d) || !street.has_parking(s + 3.0, d)) continue;
    if (random.chance(0.25)) continue;
    const double turn = (side < 0.0 ? 0.0 : kPi) + random.uniform(-0.03, 0.03);
    if (random.chance(0.04))
      town.place(make_lorry(random, label::kTruck, town.next_instance()), {s += 4.0, d}, turn);
    else
      town.place(make_car(random, label::kCar, town.next_instance()), {s, d}, turn);
  }
}

void furnish_pavement(SceneBuilder& town, double side) {
  for (double s = town.path().first(); s < town.path().last(); s += 6.0) {
    Random random = town.next_random();
    const double at = s + random.uniform(0.0, 4.0);
    if (is_near_junction(at, 7.0)) continue;
    const double by_kerb = side * (kKerb_m + 0.5);
    const double by_garden = side * (kKerb_m + kPavement_m - 0.4);
    const double kind = random.uniform();
    if (kind < 0.36)
      town.place(make_tree(random, random.uniform(1.9, 3.0), random.uniform(1.6, 3.2),
                           random.uniform(5.5, 10.0)),
                 {at, by_kerb}, random.uniform(0.0, 6.0));
    else if (kind < 0.46)
      town.place(make_pole(random.uniform(4.5, 7.0), 0.08), {at, by_kerb});
    else if (kind < 0.53)
      town.place(make_sign(random), {at, by_kerb});
    else if (kind < 0.59)
      town.place(make_bin(random), {at, by_garden}, random.uniform(0.0, 3.0));
    else if (kind < 0.63)
      town.place(make_person(random, label::kPerson, town.next_instance()), {at, by_garden});
    else if (kind < 0.72)
      town.add_mover(make_person(random, label::kMovingPerson, town.next_instance()),
                     {at, side * (kKerb_m + random.uniform(0.9, 2.2))},
                     random.chance(0.5) ? 1.3 : -1.4);
  }
}

void plant_garden(SceneBuilder& town, double s, double side, double depth_m) {
  const double front = kKerb_m + kPavement_m;
  for (int i = 0; i < 3; ++i) {
    Random random = town.next_random();
    town.place(make_bush(random, random.uniform(0.4, 1.1), random.uniform(0.6, 1.8)),
               {s + random.uniform(3.5, kLot_m - 1.0),
                side * (front + random.uniform(0.8, std::max(depth_m, 1.2)))});
  }
  Random random = town.next_random();
  if (random.chance(0.45))
    town.place(make_tree(random, random.uniform(1.2, 2.2), random.uniform(1.5, 2.6),
                         random.uniform(4.0, 7.0)),
               {s + random.uniform(5.0, kLot_m), side * (front + 0.6 * depth_m)});
}

void fence_garden(SceneBuilder& town, double s, double side) {
  Random random = town.next_random();
  const double d = side * (kKerb_m + kPavement_m + 0.35);
  const Station start{s + 5.2, d};
  const double length = kLot_m - 5.6;
  const double kind = random.uniform();
  if (kind < 0.6)
    town.place(make_hedge(length, random.uniform(0.5, 0.9), random.uniform(0.8, 1.9)), start);
  else if (kind < 0.8)
    town.place(make_wall(length, 0.12, random.uniform(0.7, 1.5), 0.3, label::kFence), start);
}

void build_lot(SceneBuilder& town, double s, double side) {
  Random random = town.next_random();
  const double middle = s + kLot_m / 2.0;
  const Junction junction = junction_near(middle);
  if (side == junction.side && std::abs(middle - junction.s) < kLot_m / 2.0 + 6.0) return;
  const double depth = random.uniform(1.5, 7.0);
  fence_garden(town, s, side);
  plant_garden(town, s, side, depth);
  if (random.chance(0.08)) return;
  const double length = random.uniform(11.0, kLot_m - 1.0);
  const double front = side * (kKerb_m + kPavement_m + 0.6 + depth);
  const Station corner{side < 0.0 ? s + 1.0 : s + 1.0 + length, front};
  town.place(make_building(random, length, random.uniform(8.0, 12.0), random.uniform(5.5, 13.0)),
             corner, side < 0.0 ? 0.0 : kPi);
}

void line_side_street(SceneBuilder& town, const Junction& junction) {
  for (const double turn : {-1.0, 1.0}) {
    const double beside = junction.s + turn * (kSideStreet_m + kPavement_m + 0.4);
    town.place(make_hedge(30.0, 0.7, 1.5), {beside, junction.side * 14.0},
               junction.side * kPi / 2.0);
    Random random = town.next_random();
    town.place(make_sign(random),
               {junction.s + turn * (kSideStreet_m + 0.5), junction.side * (kKerb_m + 1.0)});
    town.place(make_car(random, label::kCar, town.next_instance()),
               {junction.s - turn * 1.9, junction.side * random.uniform(20.0, 40.0)},
               junction.side * kPi / 2.0);
    town.place(
        make_building(random, 13.0, 10.0, 9.0),
        {junction.s + turn * 10.0, junction.side * (turn * junction.side < 0.0 ? 33.0 : 20.0)},
        turn * junction.side < 0.0 ? -junction.side * kPi / 2.0 : junction.side * kPi / 2.0);
  }
  for (double before = 10.0; before < 26.0; before += 4.0) {
    Random random = town.next_random();
    town.place(make_bush(random, 0.4, random.uniform(0.5, 0.9)), {junction.s - before, 0.0});
  }
  Random random = town.next_random();
  town.place(make_tree(random, 2.3, 1.6, 6.0), {junction.s - 18.0, 0.0});
}

void add_traffic(SceneBuilder& town) {
  Random random = town.next_random();
  town.add_mover(make_car(random, label::kMovingCar, town.next_instance()), {24.0, -kLane_m}, 10.0);
  town.add_mover(make_cyclist(random, label::kMovingBicyclist, town.next_instance()),
                 {35.0, -kLanesEdge_m + 0.3}, 4.5);
  for (double s = 45.0; s < 2.0 * town.path().last(); s += random.uniform(35.0, 90.0)) {
    const bool lorry = random.chance(0.12);
    const std::uint16_t instance = town.next_instance();
    const Random next = town.next_random();
    town.add_mover(lorry ? make_lorry(next, label::kMovingTruck, instance)
                         : make_car(next, label::kMovingCar, instance),
                   {s, kLane_m}, -9.0);
  }
}

}  // namespace

Scene make_urban(std::uint64_t seed, double length_m) {
  Random random(hash({seed, 1}));
  SceneBuilder town(seed,
                    {{random.uniform(0.06, 0.12), 260.0, random.uniform(0.0, 2.0 * kPi)},
                     {0.03, 110.0, random.uniform(0.0, 2.0 * kPi)}},
                    length_m);
  const Street street(town.shared_path(), seed);
  town.set_ground(street);
  town.set_lane(-kLane_m);
  for (const double side : {-1.0, 1.0}) {
    park_cars(town, street, side);
    furnish_pavement(town, side);
    for (double lot = std::floor(town.path().first() / kLot_m); lot * kLot_m < town.path().last();
         ++lot)
      build_lot(town, lot * kLot_m, side);
  }
  for (double s = kFirstJunction_m - 2.0 * kBetweenJunctions_m; s < town.path().last();
       s += kBetweenJunctions_m)
    if (s > town.path().first()) line_side_street(town, junction_near(s));
  add_traffic(town);
  return town.finish();
}

}  // namespace groundgrid::simulation
