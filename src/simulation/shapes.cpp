#include <cmath>
#include <numbers>

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

using Corners = std::vector<std::uint32_t>;

void add_quad(Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d,
              std::uint32_t surface) {
  mesh.add_triangle(a, b, c, surface);
  mesh.add_triangle(a, c, d, surface);
}

Corners add_ring(Mesh& mesh, const Eigen::Vector3d& centre, double radius_x, double radius_y,
                 int sides) {
  Corners ring;
  for (int i = 0; i < sides; ++i) {
    const double angle = 2.0 * std::numbers::pi * i / sides;
    ring.push_back(mesh.add_vertex(
        centre + Eigen::Vector3d(radius_x * std::cos(angle), radius_y * std::sin(angle), 0.0)));
  }
  return ring;
}

void join(Mesh& mesh, const Corners& lower, const Corners& upper, std::uint32_t surface) {
  for (std::size_t i = 0; i < lower.size(); ++i) {
    const std::size_t next = (i + 1) % lower.size();
    add_quad(mesh, lower[i], lower[next], upper[next], upper[i], surface);
  }
}

void close(Mesh& mesh, const Corners& ring, const Eigen::Vector3d& apex, bool upward,
           std::uint32_t surface) {
  const std::uint32_t top = mesh.add_vertex(apex);
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const std::size_t next = (i + 1) % ring.size();
    if (upward)
      mesh.add_triangle(ring[i], ring[next], top, surface);
    else
      mesh.add_triangle(ring[next], ring[i], top, surface);
  }
}

}  // namespace

void add_box(Mesh& mesh, const Eigen::Vector3d& least, const Eigen::Vector3d& greatest,
             std::uint32_t surface) {
  add_profile(mesh,
              {{least.x(), least.z()},
               {greatest.x(), least.z()},
               {greatest.x(), greatest.z()},
               {least.x(), greatest.z()}},
              least.y(), greatest.y(), {surface, surface, surface, surface}, surface);
}

void add_profile(Mesh& mesh, const std::vector<Eigen::Vector2d>& outline, double least_y,
                 double greatest_y, const std::vector<std::uint32_t>& surfaces,
                 std::uint32_t ends) {
  Corners right;
  Corners left;
  Eigen::Vector2d middle = Eigen::Vector2d::Zero();
  for (const Eigen::Vector2d& corner : outline) {
    right.push_back(mesh.add_vertex({corner.x(), least_y, corner.y()}));
    left.push_back(mesh.add_vertex({corner.x(), greatest_y, corner.y()}));
    middle += corner / static_cast<double>(outline.size());
  }
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = (i + 1) % outline.size();
    add_quad(mesh, right[next], right[i], left[i], left[next], surfaces[i]);
  }
  close(mesh, right, {middle.x(), least_y, middle.y()}, true, ends);
  close(mesh, left, {middle.x(), greatest_y, middle.y()}, false, ends);
}

void add_cylinder(Mesh& mesh, const Eigen::Vector3d& base, double radius_m, double top_radius_m,
                  double height_m, int sides, std::uint32_t surface) {
  const Eigen::Vector3d top = base + height_m * Eigen::Vector3d::UnitZ();
  const Corners lower = add_ring(mesh, base, radius_m, radius_m, sides);
  const Corners upper = add_ring(mesh, top, top_radius_m, top_radius_m, sides);
  join(mesh, lower, upper, surface);
  close(mesh, lower, base, false, surface);
  close(mesh, upper, top, true, surface);
}

void add_ellipsoid(Mesh& mesh, const Eigen::Vector3d& centre, const Eigen::Vector3d& radii,
                   std::uint32_t surface) {
  constexpr int kSides = 9;
  constexpr int kRings = 4;
  Corners below;
  for (int i = 1; i <= kRings; ++i) {
    const double angle = std::numbers::pi * (static_cast<double>(i) / (kRings + 1) - 0.5);
    const Eigen::Vector3d level = centre + radii.z() * std::sin(angle) * Eigen::Vector3d::UnitZ();
    const Corners ring =
        add_ring(mesh, level, radii.x() * std::cos(angle), radii.y() * std::cos(angle), kSides);
    if (i == 1)
      close(mesh, ring, centre - radii.z() * Eigen::Vector3d::UnitZ(), false, surface);
    else
      join(mesh, below, ring, surface);
    below = ring;
  }
  close(mesh, below, centre + radii.z() * Eigen::Vector3d::UnitZ(), true, surface);
}

}  // namespace groundgrid::simulation
