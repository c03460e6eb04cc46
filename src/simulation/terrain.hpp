#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <functional>
#include <vector>

#include "core/parallel.hpp"
#include "simulation/mesh.hpp"
#include "simulation/path.hpp"

namespace groundgrid::simulation {

/// What a scene says of the ground at a place.
struct Ground {
  double height_m = 0.0;     ///< Of the soil.
  std::uint16_t label = 72;  ///< SemanticKITTI class.
  double grass_m = 0.0;      ///< Height of the grass that grows on it.
};

using GroundFunction = std::function<Ground(const Eigen::Vector2d& place)>;

/// The soil as triangles: squares of 0.1 m beside the stretch of the path that is driven, larger
/// ones farther off, without cracks between them. What these triangles say is the truth, since
/// they are what rays meet.
class Terrain {
 public:
  Terrain(const Path& path, double driven_m, const GroundFunction& ground, TileRunner& runner);

  /// Height of the triangle at a place; that of the nearest edge outside of the terrain.
  [[nodiscard]] double height(const Eigen::Vector2d& place) const;

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

 private:
  struct Tile {
    int cells = 0;  ///< Along a side.
    std::vector<float> heights{};
    [[nodiscard]] std::size_t index(int column, int row) const {
      return static_cast<std::size_t>(row * (cells + 1) + column);
    }
  };
  [[nodiscard]] Eigen::Vector2d corner(std::size_t tile) const;
  static void fit_to_neighbour(Tile& tile, const Tile& neighbour, int side);
  void close_cracks();
  void add_to_mesh(const Tile& tile, const Eigen::Vector2d& corner);

  Eigen::Vector2d least_;
  std::size_t columns_ = 0;
  std::size_t rows_ = 0;
  std::vector<Tile> tiles_;
  Mesh mesh_;
};

}  // namespace groundgrid::simulation
