#include <cmath>
#include <numbers>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

// Returns per metre of ray. A crown is loose, a hedge is cut dense.
constexpr float kCrownDensity = 0.9F;
constexpr float kBushDensity = 3.0F;
constexpr float kHedgeDensity = 7.0F;

double draw(Random& random, Range range) { return random.uniform(range.least_m, range.most_m); }

std::uint32_t add_wood(Mesh& mesh) {
  return mesh.add_surface({.label = label::kTrunk, .reflectivity = 0.3F});
}

std::uint32_t add_leaves(Mesh& mesh, float density) {
  return mesh.add_surface({.label = label::kVegetation, .reflectivity = 0.35F, .density = density});
}

}  // namespace

Plant make_tree(Random random, double clearance_m, double radius_m, double height_m) {
  Plant tree;
  const double trunk = random.uniform(0.1, 0.25);
  add_cylinder(tree.wood, {0.0, 0.0, -0.5}, trunk, 0.6 * trunk, 0.7 * height_m + 0.5, 8,
               add_wood(tree.wood));
  const std::uint32_t leaves = add_leaves(tree.leaves, kCrownDensity);
  const double half = (height_m - clearance_m) / 2.0;
  const double middle = clearance_m + half;
  add_ellipsoid(tree.leaves, {0.0, 0.0, middle}, {0.8 * radius_m, 0.8 * radius_m, half}, leaves);
  for (int i = 0; i < 5; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + random.uniform()) / 5.0;
    const double out = 0.6 * radius_m;
    const double size = random.uniform(0.4, 0.55);
    add_ellipsoid(
        tree.leaves,
        {out * std::cos(angle), out * std::sin(angle), middle + random.uniform(-0.4, 0.4) * half},
        {size * radius_m, size * radius_m, 0.6 * half}, leaves);
  }
  return tree;
}

Plant make_conifer(Random random, double clearance_m, double radius_m, double height_m) {
  Plant tree;
  const double trunk = random.uniform(0.12, 0.28);
  add_cylinder(tree.wood, {0.0, 0.0, -0.8}, trunk, 0.5 * trunk, 0.8 * height_m + 0.8, 8,
               add_wood(tree.wood));
  add_cylinder(tree.leaves, {0.0, 0.0, clearance_m}, radius_m, 0.1 * radius_m,
               height_m - clearance_m, 10, add_leaves(tree.leaves, kCrownDensity));
  return tree;
}

Plant make_bush(Random random, double radius_m, double height_m) {
  Plant bush;
  const std::uint32_t leaves = add_leaves(bush.leaves, kBushDensity);
  for (int i = 0; i < 3; ++i) {
    const double x = random.uniform(-0.4, 0.4) * radius_m;
    const double y = random.uniform(-0.4, 0.4) * radius_m;
    add_ellipsoid(bush.leaves, {x, y, 0.4 * height_m},
                  {0.75 * radius_m, 0.75 * radius_m, 0.6 * height_m}, leaves);
  }
  return bush;
}

// Drawn one after another: the order in which arguments are evaluated is not given.
Plant make_tree(Random random, Range clearance, Range radius, Range height) {
  const double clearance_m = draw(random, clearance);
  const double radius_m = draw(random, radius);
  const double height_m = draw(random, height);
  return make_tree(random, clearance_m, radius_m, height_m);
}

Plant make_conifer(Random random, Range clearance, Range radius, Range height) {
  const double clearance_m = draw(random, clearance);
  const double radius_m = draw(random, radius);
  const double height_m = draw(random, height);
  return make_conifer(random, clearance_m, radius_m, height_m);
}

Plant make_bush(Random random, Range radius, Range height) {
  const double radius_m = draw(random, radius);
  const double height_m = draw(random, height);
  return make_bush(random, radius_m, height_m);
}

Plant make_hedge(double length_m, double depth_m, double height_m) {
  Plant hedge;
  add_box(hedge.leaves, {0.0, -depth_m / 2.0, -0.3}, {length_m, depth_m / 2.0, height_m},
          add_leaves(hedge.leaves, kHedgeDensity));
  return hedge;
}

}  // namespace groundgrid::simulation
