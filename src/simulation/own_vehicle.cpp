#include "simulation/own_vehicle.hpp"

#include "simulation/objects.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kRoof_m = 1.48;

}  // namespace

// Laid out so that the lowest lasers of an HDL-64E lose their echoes to the front and the rear and
// find some at the same places as in KITTI's scans. The roof itself is nearer than a dataset keeps
// points, so that nothing comes back from it.
Mesh make_own_vehicle(double sensor_height_m) {
  Mesh mesh;
  const std::uint32_t roof = mesh.add_surface({.label = label::kUnlabeled, .reflectivity = 0.0F});
  const std::uint32_t rack = mesh.add_surface({.label = label::kUnlabeled, .reflectivity = 0.1F});
  if (sensor_height_m > kRoof_m) {
    add_box(mesh, {-1.06, -0.42, kRoof_m - 0.1}, {0.2, 0.42, kRoof_m}, roof);
    add_box(mesh, {0.2, -0.22, kRoof_m - 0.1}, {0.86, 0.22, kRoof_m}, roof);
  }
  add_box(mesh, {-1.21, 1.1, 1.1}, {-1.19, 1.12, 1.18}, rack);
  add_box(mesh, {-1.45, -1.33, 1.02}, {-1.43, -1.31, 1.1}, rack);
  add_box(mesh, {1.62, 1.41, 1.17}, {1.64, 1.43, 1.25}, rack);
  return mesh;
}

}  // namespace groundgrid::simulation
