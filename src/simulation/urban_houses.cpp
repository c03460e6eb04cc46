#include "simulation/urban_houses.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace groundgrid::simulation::urban {
namespace {

using std::numbers::pi;

constexpr double kParkDepth_m = 16.0;
constexpr double kBehindDrive_m = 5.2;  // From the beginning of a lot.
constexpr float kFenceDensity = 12.0F;
constexpr float kFlowerDensity = 6.0F;

/// Posts and what is between them, which lets about half of the rays through.
Plant make_fence(double length_m, double height_m) {
  Plant fence;
  const std::uint32_t post = fence.wood.add_surface({.label = label::kFence, .reflectivity = 0.3F});
  for (const double x : every(2.4, 0.0, length_m))
    add_box(fence.wood, {x, -0.04, -0.3}, {x + 0.08, 0.04, height_m + 0.05}, post);
  const std::uint32_t panel = fence.leaves.add_surface(
      {.label = label::kFence, .reflectivity = 0.3F, .density = kFenceDensity});
  add_box(fence.leaves, {0.0, -0.03, -0.2}, {length_m, 0.03, height_m}, panel);
  return fence;
}

/// Up to a door, out of the wall at y = 0; each step as deep as it is needed to walk.
Mesh make_stairs(int steps, double width_m) {
  Mesh mesh;
  const std::uint32_t stone = mesh.add_surface({.label = label::kBuilding, .reflectivity = 0.35F});
  for (int i = 0; i < steps; ++i)
    add_box(mesh, {0.0, 0.0, -0.3}, {width_m, 0.3 * (steps - i) + 0.5, 0.17 * (i + 1)}, stone);
  return mesh;
}

void bound_garden(SceneBuilder& town, const Garden& garden, double s, double side) {
  Random random = town.next_random();
  const Station start{s + kBehindDrive_m, side * (kGardens_m + 0.3)};
  const double length = kLot_m - kBehindDrive_m - 0.6;
  if (garden.kind == Garden::Kind::terrace)
    town.place(
        make_wall(length, 0.3, garden.rise_m + random.uniform(0.0, 0.25), 0.9, label::kFence),
        {start.s, side * (kGardens_m + 0.05)});
  const double kind = random.uniform();
  if (kind < 0.5) {
    const double depth = random.uniform(0.4, 0.9);
    town.place(make_hedge(length, depth, random.uniform(0.5, 2.0)), start);
  } else if (kind < 0.72) {
    town.place(make_fence(length, random.uniform(0.7, 1.3)), start);
  } else if (kind < 0.84 && garden.kind != Garden::Kind::terrace) {
    town.place(make_wall(length, 0.2, random.uniform(0.25, 0.9), 0.4, label::kFence), start);
  }
}

void plant_garden(SceneBuilder& town, double s, double side, double depth_m) {
  for (int i = 0; i < 11; ++i) {
    Random random = town.next_random();
    const double radius = random.uniform(0.3, 1.2);
    const double height = random.uniform(0.2, 2.2);
    const double along = random.uniform(kBehindDrive_m, kLot_m - 1.0);
    const double into = random.uniform(0.7, std::max(depth_m, 1.2));
    town.place(make_bush(random, radius, height), {s + along, side * (kGardens_m + into)});
  }
  for (int i = 0; i < 3; ++i) {
    Random random = town.next_random();
    const double clearance = random.uniform(0.6, 1.8);
    const double radius = random.uniform(1.6, 3.2);
    const double height = random.uniform(4.0, 9.0);
    const double along = random.uniform(kBehindDrive_m, kLot_m);
    const double into = random.uniform(0.4, 0.7) * depth_m;
    if (random.chance(0.8))
      town.place(make_tree(random, clearance, radius, height),
                 {s + along, side * (kGardens_m + into)});
  }
}

/// A car on the drive, bins and tubs before the house.
void use_yard(SceneBuilder& town, double s, double side, double depth_m) {
  Random random = town.next_random();
  if (depth_m > 4.5 && random.chance(0.5))
    town.place(make_car(random, label::kCar, town.next_instance()),
               {s + kDrive_m, side * (kGardens_m + 2.7)}, side * pi / 2.0);
  for (int i = 0; i < 3; ++i) {
    const double along = random.uniform(kBehindDrive_m, kLot_m - 2.0);
    const double before = random.uniform(0.3, 0.8);
    const Station at{s + along, side * (kGardens_m + std::max(depth_m - before, 0.2))};
    if (random.chance(0.5))
      town.place(make_bin(random), at);
    else
      town.place(make_planter(random.uniform(0.5, 1.5), 0.4), at);
  }
}

void build_house(SceneBuilder& town, double s, double side, double depth_m) {
  Random random = town.next_random();
  const double length = random.uniform(11.0, kLot_m - 1.0);
  const double size = random.uniform(8.0, 12.0);
  const double height = random.uniform(5.5, 13.0);
  const double front = side * (kGardens_m + 0.3 + depth_m);
  const double turn = side < 0.0 ? 0.0 : pi;
  const double first = side < 0.0 ? s + 1.0 : s + 1.0 + length;
  town.place(make_building(random, length, size, height), {first, front}, turn);
  const int steps = static_cast<int>(random.uniform(1.0, 5.0));
  const double width = random.uniform(1.2, 2.4);
  const double door = s + 1.0 + random.uniform(0.35, 0.75) * length;
  town.place(make_stairs(steps, width), {door, front}, turn);
  // Shafts before the windows of the cellar, and a plinth.
  for (const double x : every(random.uniform(2.5, 5.0), s + 2.0, s + length - 1.0)) {
    const double high = random.uniform(0.1, 0.45);
    town.place(make_wall(1.1, 1.0, high, 0.3, label::kBuilding), {x, front});
  }
}

}  // namespace

Plant make_planter(double length_m, double height_m) {
  Plant planter;
  const std::uint32_t stone =
      planter.wood.add_surface({.label = label::kOtherObject, .reflectivity = 0.35F});
  add_box(planter.wood, {0.0, -0.25, -0.1}, {length_m, 0.25, height_m}, stone);
  const std::uint32_t flowers = planter.leaves.add_surface(
      {.label = label::kVegetation, .reflectivity = 0.35F, .density = kFlowerDensity});
  add_box(planter.leaves, {0.05, -0.2, height_m}, {length_m - 0.05, 0.2, height_m + 0.25}, flowers);
  return planter;
}

void build_lot(SceneBuilder& town, const Street& street, double s, double side) {
  Random random = town.next_random();
  const double middle = s + kLot_m / 2.0;
  const Junction junction = junction_near(middle);
  if (side == junction.side && std::abs(middle - junction.s) < kLot_m / 2.0 + 6.0) return;
  const Garden garden = street.garden(middle, side);
  const bool paved = garden.kind == Garden::Kind::paved;
  const double depth = paved ? random.uniform(0.0, 2.0) : random.uniform(3.0, 7.0);
  if (!paved) {
    bound_garden(town, garden, s, side);
    plant_garden(town, s, side, depth);
  }
  use_yard(town, s, side, depth);
  if (random.chance(0.82))
    build_house(town, s, side, depth);
  else
    plant_garden(town, s, side, kParkDepth_m);
}

}  // namespace groundgrid::simulation::urban
