#pragma once

#include <Eigen/Geometry>
#include <cstdint>

#include "simulation/scene.hpp"
#include "simulation/terrain.hpp"

namespace groundgrid::simulation {

/// The way of the vehicle through a scene, with pitch and roll from the soil under its wheels and
/// from its springs. It begins level, so that the frame of the first scan is upright.
class Drive {
 public:
  /// The scene and the terrain must outlive the drive.
  Drive(const Scene& scene, const Terrain& terrain, std::uint64_t seed);

  /// T_world_base at a time in seconds after the first scan. The base is on the ground under the
  /// middle of the vehicle, x forward.
  [[nodiscard]] Eigen::Isometry3d pose(double time_s) const;

 private:
  const Scene* scene_;
  const Terrain* terrain_;
  double phase_;
};

}  // namespace groundgrid::simulation
