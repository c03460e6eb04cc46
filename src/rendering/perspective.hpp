#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "rendering/color.hpp"
#include "rendering/image.hpp"

namespace groundgrid::rendering {

/// A coloured corner of a triangle, or a coloured point.
struct Vertex {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
  float size_m = 0.0F;  ///< Diameter of a point.
  Color color{};
  std::uint8_t unused = 0;
};

/// What is looked at, metres, z up. Coordinates are single, so its origin should be near.
struct Scene {
  std::vector<Vertex> corners{};
  std::vector<std::uint32_t> triangles{};  ///< Three corners each.
  std::vector<Vertex> points{};
  double least_point_px = 1.0;  ///< No point is drawn smaller.
  double depth_shading = 1.0;   ///< How dark what lies behind an edge is; 0: not at all.
};

/// Who looks.
struct Camera {
  Eigen::Vector3d eye{-20.0, 0.0, 15.0};
  Eigen::Vector3d target{0.0, 0.0, 0.0};
  double vertical_field_deg = 40.0;
};

/// Coordinates of the scene into those of the picture: after division by the fourth, x from -1 to 1
/// is its width, y from -1 (below) to 1 its height.
Eigen::Matrix4d projection_of(const Camera& camera, double aspect);

/// Draws scenes with OpenGL, without a display. One object draws many pictures.
class PerspectiveRenderer {
 public:
  /// Throws std::runtime_error where there is no OpenGL.
  PerspectiveRenderer();
  ~PerspectiveRenderer();
  PerspectiveRenderer(const PerspectiveRenderer&) = delete;
  PerspectiveRenderer& operator=(const PerspectiveRenderer&) = delete;
  PerspectiveRenderer(PerspectiveRenderer&&) = delete;
  PerspectiveRenderer& operator=(PerspectiveRenderer&&) = delete;

  /// On white; edges are smooth. Throws std::runtime_error where OpenGL fails.
  [[nodiscard]] Image draw(const Scene& scene, const Camera& camera, ImageSize size) const;

 private:
  class Programs;
  std::unique_ptr<Programs> programs_;
};

}  // namespace groundgrid::rendering
