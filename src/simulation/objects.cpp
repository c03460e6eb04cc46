#include "simulation/objects.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace groundgrid::simulation {
namespace {

void add_wheels(Mesh& mesh, double front_x, double rear_x, double half_width, double radius,
                std::uint32_t surface) {
  for (const double x : {front_x, rear_x})
    for (const double side : {-1.0, 1.0}) {
      const double outer = side * half_width;
      const double inner = side * (half_width - 0.2);
      std::vector<Eigen::Vector2d> outline;
      for (int i = 0; i < 10; ++i) {
        const double angle = 2.0 * std::numbers::pi * i / 10.0;
        outline.emplace_back(x + radius * std::cos(angle), radius + radius * std::sin(angle));
      }
      add_profile(mesh, outline, std::min(inner, outer), std::max(inner, outer),
                  std::vector<std::uint32_t>(outline.size(), surface), surface);
    }
}

}  // namespace

Mesh make_car(Random random, std::uint16_t label, std::uint16_t instance) {
  Mesh mesh;
  const float colour = static_cast<float>(random.uniform(0.05, 0.6));
  const std::uint32_t paint = mesh.add_surface({label, instance, Material::paint, colour, 0.0F});
  const std::uint32_t glass = mesh.add_surface({label, instance, Material::glass, 0.1F, 0.0F});
  const std::uint32_t rubber = mesh.add_surface({label, instance, Material::matt, 0.05F, 0.0F});
  const double half = random.uniform(1.95, 2.35);
  const double top = random.uniform(1.4, 1.75);
  const double half_width = random.uniform(0.82, 0.92);
  const double sill = random.uniform(0.16, 0.28);
  const double belt = random.uniform(0.88, 1.0);
  add_profile(mesh, {{-half, sill}, {half, sill}, {half, 0.7}, {half - 1.1, belt}, {-half, belt}},
              -half_width, half_width, {paint, paint, paint, paint, paint}, paint);
  add_profile(mesh,
              {{-half + 0.1, belt}, {half - 1.1, belt}, {half - 1.9, top}, {-half + 0.5, top}},
              -half_width + 0.1, half_width - 0.1, {paint, glass, paint, glass}, glass);
  add_wheels(mesh, half - 0.85, -half + 0.85, half_width, 0.31, rubber);
  return mesh;
}

Mesh make_lorry(Random random, std::uint16_t label, std::uint16_t instance) {
  Mesh mesh;
  const std::uint32_t canvas = mesh.add_surface(
      {label, instance, Material::matt, static_cast<float>(random.uniform(0.2, 0.7)), 0.0F});
  const std::uint32_t paint = mesh.add_surface({label, instance, Material::paint, 0.4F, 0.0F});
  const std::uint32_t rubber = mesh.add_surface({label, instance, Material::matt, 0.05F, 0.0F});
  const double half = random.uniform(4.0, 6.5);
  add_box(mesh, {-half, -1.25, 1.05}, {half - 2.3, 1.25, random.uniform(3.2, 3.9)}, canvas);
  add_box(mesh, {half - 2.0, -1.2, 0.4}, {half, 1.2, 3.0}, paint);
  add_box(mesh, {-half + 0.3, -0.5, 0.75}, {half - 2.0, 0.5, 1.05}, rubber);
  add_wheels(mesh, half - 1.0, -half + 1.2, 1.2, 0.5, rubber);
  add_wheels(mesh, half - 3.2, -half + 2.4, 1.2, 0.5, rubber);
  return mesh;
}

Mesh make_person(Random random, std::uint16_t label, std::uint16_t instance) {
  Mesh mesh;
  const std::uint32_t cloth = mesh.add_surface(
      {label, instance, Material::matt, static_cast<float>(random.uniform(0.1, 0.5)), 0.0F});
  const double size = random.uniform(0.9, 1.08);
  const double stride = random.uniform(0.05, 0.3);
  add_cylinder(mesh, {stride, 0.1, 0.0}, 0.08, 0.1, 0.85 * size, 6, cloth);
  add_cylinder(mesh, {-stride, -0.1, 0.0}, 0.08, 0.1, 0.85 * size, 6, cloth);
  add_cylinder(mesh, {0.0, 0.0, 0.8 * size}, 0.19, 0.22, 0.65 * size, 8, cloth);
  add_cylinder(mesh, {0.0, 0.0, 1.45 * size}, 0.1, 0.1, 0.3 * size, 6, cloth);
  return mesh;
}

Mesh make_cyclist(Random random, std::uint16_t label, std::uint16_t instance) {
  Mesh mesh;
  Eigen::Isometry3d on_saddle = Eigen::Isometry3d::Identity();
  on_saddle.translation().z() = 0.25;
  mesh.append(make_person(random, label, instance), on_saddle);
  const std::uint32_t metal = mesh.add_surface({label, instance, Material::matt, 0.2F, 0.0F});
  add_box(mesh, {-0.85, -0.02, 0.05}, {-0.2, 0.02, 0.65}, metal);
  add_box(mesh, {0.2, -0.02, 0.05}, {0.85, 0.02, 0.65}, metal);
  add_box(mesh, {-0.3, -0.03, 0.5}, {0.6, 0.03, 0.95}, metal);
  return mesh;
}

Mesh make_pole(double height_m, double radius_m) {
  Mesh mesh;
  const std::uint32_t metal = mesh.add_surface({.label = label::kPole, .reflectivity = 0.4F});
  add_cylinder(mesh, {0.0, 0.0, -0.5}, radius_m, radius_m, height_m + 0.5, 8, metal);
  return mesh;
}

Mesh make_sign(Random random) {
  const double height = random.uniform(2.0, 2.5);
  Mesh mesh = make_pole(height + 0.3, 0.035);
  const std::uint32_t plate =
      mesh.add_surface({.label = label::kTrafficSign, .reflectivity = 0.95F});
  add_box(mesh, {-0.06, -0.3, height - 0.3}, {-0.04, 0.3, height + 0.3}, plate);
  return mesh;
}

Mesh make_bin(Random random) {
  Mesh mesh;
  const std::uint32_t plastic =
      mesh.add_surface({.label = label::kOtherObject, .reflectivity = 0.15F});
  add_box(mesh, {-0.3, -0.3, 0.0}, {0.3, 0.3, random.uniform(0.6, 1.15)}, plastic);
  return mesh;
}

Mesh make_rock(Random random) {
  Mesh mesh;
  const std::uint32_t stone =
      mesh.add_surface({.label = label::kOtherObject, .reflectivity = 0.3F});
  const double size = random.uniform(0.25, 0.9);
  add_ellipsoid(mesh, {0.0, 0.0, 0.1 * size},
                {size, size * random.uniform(0.6, 1.0), size * random.uniform(0.5, 0.9)}, stone);
  return mesh;
}

Mesh make_building(Random random, double length_m, double depth_m, double height_m) {
  Mesh mesh;
  const std::uint32_t wall = mesh.add_surface(
      {.label = label::kBuilding, .reflectivity = static_cast<float>(random.uniform(0.2, 0.6))});
  const std::uint32_t window = mesh.add_surface(
      {.label = label::kBuilding, .material = Material::glass, .reflectivity = 0.1F});
  add_box(mesh, {0.0, -depth_m, -3.0}, {length_m, 0.0, height_m}, wall);
  // The gable roof.
  const double ridge = height_m + random.uniform(2.0, 4.0);
  add_box(mesh, {0.0, -0.7 * depth_m, height_m}, {length_m, -0.3 * depth_m, ridge}, wall);
  for (double floor = 1.0; floor + 1.4 < height_m; floor += 2.9)
    for (double x = 1.2; x + 1.2 < length_m; x += 2.8)
      add_box(mesh, {x, -0.05, floor}, {x + 1.1, 0.01, floor + 1.3}, window);
  return mesh;
}

Mesh make_wall(double length_m, double depth_m, double height_m, double foot_m,
               std::uint16_t label) {
  Mesh mesh;
  const std::uint32_t stone = mesh.add_surface({.label = label, .reflectivity = 0.35F});
  add_box(mesh, {0.0, -depth_m / 2.0, -foot_m}, {length_m, depth_m / 2.0, height_m}, stone);
  return mesh;
}

}  // namespace groundgrid::simulation
