#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace groundgrid::simulation {

/// What a triangle is made of.
enum class Material : std::uint8_t {
  matt,
  paint,  ///< A car's body: reflects some rays on, and others away.
  glass,  ///< Lets most rays through to where nothing comes back.
};

/// What is known of a surface.
struct Surface {
  std::uint16_t label = 0;  ///< SemanticKITTI class.
  std::uint16_t instance = 0;
  Material material = Material::matt;
  float reflectivity = 0.3F;  ///< 0 to 1, also the intensity at normal incidence.
  float density = 0.0F;       ///< Of a volume: the mean number of returns in a metre of ray.
};

/// Triangles, each with the index of its surface. Metres; seen from outside the corners of a
/// triangle run anticlockwise.
struct Mesh {
  std::vector<Eigen::Vector3f> vertices{};
  std::vector<std::array<std::uint32_t, 3>> triangles{};
  std::vector<Surface> surfaces{};
  std::vector<std::uint32_t> surface_of{};  ///< Of each triangle.

  [[nodiscard]] const Surface& surface(std::size_t triangle) const {
    return surfaces[surface_of[triangle]];
  }

  std::uint32_t add_surface(const Surface& surface) {
    surfaces.push_back(surface);
    return static_cast<std::uint32_t>(surfaces.size() - 1);
  }

  std::uint32_t add_vertex(const Eigen::Vector3d& place) {
    vertices.emplace_back(place.cast<float>());
    return static_cast<std::uint32_t>(vertices.size() - 1);
  }

  void add_triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t surface) {
    triangles.push_back({a, b, c});
    surface_of.push_back(surface);
  }

  /// Adds all of another mesh, moved.
  void append(const Mesh& other, const Eigen::Isometry3d& T_this_other) {
    const auto first_vertex = static_cast<std::uint32_t>(vertices.size());
    const auto first_surface = static_cast<std::uint32_t>(surfaces.size());
    for (const Eigen::Vector3f& vertex : other.vertices)
      add_vertex(T_this_other * vertex.cast<double>());
    surfaces.insert(surfaces.end(), other.surfaces.begin(), other.surfaces.end());
    for (std::size_t i = 0; i < other.triangles.size(); ++i) {
      const auto& [a, b, c] = other.triangles[i];
      add_triangle(first_vertex + a, first_vertex + b, first_vertex + c,
                   first_surface + other.surface_of[i]);
    }
  }
};

}  // namespace groundgrid::simulation
