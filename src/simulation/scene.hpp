#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "simulation/mesh.hpp"
#include "simulation/path.hpp"
#include "simulation/terrain.hpp"

namespace groundgrid::simulation {

/// Something that moves along the path.
struct Mover {
  Mesh mesh;               ///< In its own frame, x forward.
  Station start{};         ///< Where it is when the drive begins.
  double speed_mps = 0.0;  ///< Along the path; negative against it.
};

/// A world to drive through. Its frame has x along the path's beginning and z up.
struct Scene {
  std::shared_ptr<const Path> path;
  GroundFunction ground;
  double lane_m = 0.0;  ///< Left of the path.
  double speed_mps = 10.0;
  Mesh solids{};
  Mesh leaves{};  ///< Closed volumes.
  std::vector<Mover> movers{};
};

/// The names that make_scene() takes.
const std::vector<std::string>& scene_names();

/// The speed at which a scene is driven through. Throws std::invalid_argument as make_scene().
double scene_speed_mps(const std::string& name);

/// Builds a scene along `length_m` of path. Throws std::invalid_argument where there is none of
/// that name.
Scene make_scene(const std::string& name, std::uint64_t seed, double length_m);

}  // namespace groundgrid::simulation
