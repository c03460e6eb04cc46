#pragma once

#include <cstdint>
#include <optional>

#include "simulation/random.hpp"
#include "simulation/ray_caster.hpp"
#include "simulation/scene.hpp"
#include "simulation/terrain.hpp"

namespace groundgrid::simulation {

/// What comes back of one ray, before the sensor's noise.
struct Echo {
  double distance_m = 0.0;  ///< 0 where nothing comes back.
  std::uint32_t label = 0;  ///< SemanticKITTI class, and the instance in the upper 16 bits.
  float intensity = 0.0F;   ///< 0 to 1.
  bool soil = false;        ///< From the ground or the grass on it.
};

/// The world at one moment, as rays see it.
class World {
 public:
  /// The scene and the terrain must outlive the world.
  World(const Scene& scene, const Terrain& terrain);

  /// Puts all that moves where it is at a time, as far as it is near to a place.
  void move_to(double time_s, const Eigen::Vector2d& place);

  [[nodiscard]] Echo echo(const Ray& ray, double least_m, double most_m, Random random) const;

  /// Whether leaves, not fences and the like, are above a place.
  [[nodiscard]] bool is_under_leaves(const Eigen::Vector2d& place) const;

  [[nodiscard]] const Terrain& terrain() const { return *terrain_; }

 private:
  struct Touch {
    double distance_m = 0.0;
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();
    Surface surface{};
    double grass_m = 0.0;
    bool soil = false;
  };
  [[nodiscard]] std::optional<Touch> touch(const Ray& ray, double least_m, double most_m) const;
  [[nodiscard]] std::optional<Touch> touch_leaves(const Ray& ray, double most_m,
                                                  Random& random) const;
  [[nodiscard]] Echo reflection(const Ray& ray, const Touch& first, double most_m) const;

  const Scene* scene_;
  const Terrain* terrain_;
  RayCaster still_;
  RayCaster leaves_;
  Mesh moving_mesh_{};
  RayCaster moving_;
};

}  // namespace groundgrid::simulation
