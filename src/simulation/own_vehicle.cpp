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
  if (sensor_height_m > kRoof_m)
    add_box(mesh, {-1.06, -0.6, kRoof_m - 0.1}, {0.86, 0.6, kRoof_m}, roof);
  add_box(mesh, {-1.22, 1.09, 1.1}, {-1.19, 1.12, 1.2}, rack);
  add_box(mesh, {-1.46, -1.34, 1.0}, {-1.43, -1.31, 1.1}, rack);
  add_box(mesh, {1.61, 1.4, 1.15}, {1.64, 1.43, 1.25}, rack);
  return mesh;
}

}  // namespace groundgrid::simulation
