#pragma once

#include <Eigen/Geometry>
#include <span>
#include <vector>

#include "core/parallel.hpp"
#include "geotiff/raster_grid.hpp"
#include "simulation/echo.hpp"

namespace groundgrid::simulation {

/// Cells of 0.2 m up to 80 m around the places of a drive, of which there is at least one. The
/// origin is a corner of four of them.
geotiff::RasterGrid grid_around(std::span<const Eigen::Isometry3d> poses);

/// What is true of the middle of each cell of a raster, row by row from the south. The raster's
/// origin is at a place of the world.
class TruthRasters {
 public:
  /// World and runner must outlive this.
  TruthRasters(const World& world, const geotiff::RasterGrid& grid, Eigen::Vector3d origin,
               TileRunner& runner);

  /// Of the soil, metres above the origin.
  [[nodiscard]] std::vector<float> heights() const;

  /// 1 where leaves are above, else 0.
  [[nodiscard]] std::vector<float> under_leaves() const;

  /// 1 within 0.3 m of where the soil rises by 5 cm and more over 0.3 m beyond its slope over a
  /// metre, else 0.
  [[nodiscard]] std::vector<float> at_kerbs() const;

 private:
  template <typename Function>
  [[nodiscard]] std::vector<float> for_each_cell(const Function& value) const;
  [[nodiscard]] bool is_step(const Eigen::Vector2d& place) const;

  const World* world_;
  geotiff::RasterGrid grid_;
  Eigen::Vector3d origin_;
  TileRunner* runner_;
};

}  // namespace groundgrid::simulation
