#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace groundgrid {

/// z(x, y) = height + slope_x · x + slope_y · y, metres from a point that goes with it.
struct LocalPlane {
  double height = 0.0;
  double slope_x = 0.0;
  double slope_y = 0.0;
};

/// A surface of planes over a square of cells: one block covers them all, each block has nine of a
/// third of its side below it, down to 5 × 5 cells. The middle cell is in the middle of a block on
/// every level, so that no direction is special. Not in the paper; see docs/method.md.
///
/// A block's plane is expected to be what the planes above it say there, give or take a roughness
/// that grows with its side, and is corrected by the heights of its own cells: least squares with
/// a prior. Blocks without heights carry on with the planes above, so that there is a surface
/// everywhere, near to the heights where there are any and as smooth as they allow elsewhere.
class PlaneHierarchy {
 public:
  /// For `size` × `size` cells, an odd number.
  PlaneHierarchy(int size, double cell_size_m);

  /// The finest level whose blocks are at least this wide; 0 is 5 × 5 cells.
  [[nodiscard]] std::size_t level_of(double block_m) const;

  /// Fits the planes of all levels down to `finest` to heights of cells (row by row, metres) with
  /// weights of 0 to 1, cells of weight 0 apart. `top` is the plane expected at the middle.
  void fit(std::span<const float> weights, std::span<const float> heights, const LocalPlane& top,
           std::size_t finest);

  /// The surface at the middle of each cell, bilinear between the planes of a level.
  void evaluate(std::size_t level, std::span<float> surface);

  /// The variance of that height at each cell, m²: bilinear between those of the planes.
  void evaluate_variance(std::size_t level, std::span<float> variance);

 private:
  /// Weighted sums over the cells of a block; x and y from its middle, metres.
  struct Sums {
    double w = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, z = 0.0, xz = 0.0, yz = 0.0;
  };
  /// A block's plane from its middle, and the variances of its three numbers.
  struct BlockPlane {
    LocalPlane plane{};
    LocalPlane variance{};
  };
  struct Level {
    int blocks = 0;     ///< A side, an odd number.
    int before = 0;     ///< Blocks (or cells) of the level below by which the first begins early.
    double side = 0.0;  ///< Of a block, metres.
    std::vector<Sums> sums{};
    std::vector<BlockPlane> planes{};

    [[nodiscard]] std::size_t index(int column, int row) const {
      return static_cast<std::size_t>(row) * static_cast<std::size_t>(blocks) +
             static_cast<std::size_t>(column);
    }
  };
  /// A cell's middle between the middles of two blocks, along one axis.
  struct Between {
    std::size_t before = 0;
    std::size_t after = 0;
    float share_after = 0.0F;
    float from_before = 0.0F;  ///< Metres from the middle of the one before.
    float from_after = 0.0F;
  };

  void sum_finest(std::span<const float> weights, std::span<const float> heights);
  static void sum_up(const Level& below, Level& level);
  static BlockPlane expected(const Level& above, double side, int column, int row);
  static BlockPlane corrected(const BlockPlane& expected, const Sums& sums, double side);
  void place_cells(const Level& level);

  int size_;
  double cell_size_;
  std::vector<Level> levels_;  // finest first
  std::vector<Between> between_;
  std::vector<float> row_height_;
  std::vector<float> row_slope_;
};

}  // namespace groundgrid
