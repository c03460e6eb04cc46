#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "simulation/mesh.hpp"

namespace groundgrid::simulation {

struct Ray {
  Eigen::Vector3d origin;
  Eigen::Vector3d direction;  ///< Of length 1.
};

struct Hit {
  double distance_m = 0.0;
  std::uint32_t mesh = 0;
  std::uint32_t triangle = 0;
  Eigen::Vector3d normal;  ///< Of length 1, outward.
};

/// Finds where rays meet triangles. The same for any number of threads that ask; the meshes are
/// copied.
class RayCaster {
 public:
  explicit RayCaster(const std::vector<const Mesh*>& meshes);
  ~RayCaster();
  RayCaster(const RayCaster&) = delete;
  RayCaster& operator=(const RayCaster&) = delete;
  RayCaster(RayCaster&&) noexcept;
  RayCaster& operator=(RayCaster&&) noexcept;

  /// The first hit that is more than `least_m` and less than `most_m` away, from either side.
  [[nodiscard]] std::optional<Hit> cast(const Ray& ray, double least_m, double most_m) const;

 private:
  struct Scene;
  std::unique_ptr<Scene> scene_;
};

}  // namespace groundgrid::simulation
