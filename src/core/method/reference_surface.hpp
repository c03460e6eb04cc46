#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/method/constants.hpp"
#include "core/stages/plane_hierarchy.hpp"

/// The surface of planes as plain code; see reference_method.cpp.
namespace groundgrid::reference {

/// One element for each cell of the window, row by row.
template <typename T>
using PerCell = std::vector<T>;

/// A square of cells.
struct Window {
  int size = 0;
  double cell_size = 0.0;

  [[nodiscard]] std::size_t cells() const { return static_cast<std::size_t>(size * size); }
  [[nodiscard]] int middle() const { return size / 2; }
  [[nodiscard]] bool contains(int column, int row) const {
    return column >= 0 && row >= 0 && column < size && row < size;
  }
  [[nodiscard]] std::uint32_t cell(int column, int row) const {
    return static_cast<std::uint32_t>(row * size + column);
  }
  [[nodiscard]] int column(std::uint32_t cell) const { return static_cast<int>(cell) % size; }
  [[nodiscard]] int row(std::uint32_t cell) const { return static_cast<int>(cell) / size; }
};

/// A block's plane from its middle, with the variances of its three numbers.
struct BlockPlane {
  float height = 0.0F;
  std::array<float, 2> slope{};  ///< Along x and y.
  float variance_height = 0.0F;
  std::array<float, 2> variance_slope{};
};

/// Weighted sums over the cells of a block; x and y from its middle, metres.
struct BlockSum {
  float w = 0.0F, x = 0.0F, y = 0.0F, xx = 0.0F, xy = 0.0F, yy = 0.0F;
  float z = 0.0F, xz = 0.0F, yz = 0.0F;
};

struct Level {
  int blocks = 0;  ///< A side.
  int cells = 0;   ///< Of a block, a side.
  double side = 0.0;
  std::vector<BlockPlane> planes{};

  [[nodiscard]] int middle_block() const { return blocks / 2; }
  [[nodiscard]] int middle_cell() const { return cells / 2; }  ///< Of a block.
  [[nodiscard]] std::size_t block(int x, int y) const {
    return static_cast<std::size_t>(y * blocks + x);
  }
};

/// Planes on all levels: one block covers everything, each block has nine of a third of its side
/// below it, down to 5 × 5 cells. The middle cell is in the middle of a block on every level.
class Surface {
 public:
  /// Fits planes down to blocks of at least `block_m` to heights with weights.
  Surface(const Window& window, const PerCell<float>& heights, const PerCell<float>& weights,
          const LocalPlane& top, double block_m)
      : window_(window) {
    for (int cells = constants::kFinestBlock, half = window.size / 2;;
         cells *= constants::kBranch) {
      const int parts = levels_.empty() ? constants::kFinestBlock : constants::kBranch;
      half = (half + parts / 2) / parts;
      levels_.push_back({2 * half + 1, cells, cells * window.cell_size, {}});
      if (half == 0) break;
    }
    while (finest_ + 1 < levels_.size() && levels_[finest_].side < block_m) ++finest_;
    fit(heights, weights, top);
  }

  /// Between the planes of the blocks around a cell: linear along x, then along y.
  [[nodiscard]] float at(std::uint32_t cell) const {
    const Level& level = levels_[finest_];
    const Place x = place(level, window_.column(cell));
    const Place y = place(level, window_.row(cell));
    const auto along_x = [&](int block_row, float from) {
      const BlockPlane& left = level.planes[level.block(x.before, block_row)];
      const BlockPlane& right = level.planes[level.block(x.after, block_row)];
      const float height_left = left.height + left.slope[0] * x.from_before;
      const float height_right = right.height + right.slope[0] * x.from_after;
      const float height = height_left + x.share_after * (height_right - height_left);
      const float slope = left.slope[1] + x.share_after * (right.slope[1] - left.slope[1]);
      return height + slope * from;
    };
    const float lower = along_x(y.before, y.from_before);
    const float upper = along_x(y.after, y.from_after);
    return lower + y.share_after * (upper - lower);
  }

 private:
  /// Where a column or row lies between the middles of two blocks.
  struct Place {
    int before = 0;
    int after = 0;
    float share_after = 0.0F;
    float from_before = 0.0F;
    float from_after = 0.0F;
  };

  [[nodiscard]] Place place(const Level& level, int i) const {
    const double in_blocks =
        (i - window_.middle()) * window_.cell_size / level.side + level.middle_block();
    const int floor = static_cast<int>(std::floor(in_blocks));
    Place result;
    result.before = std::clamp(floor, 0, level.blocks - 1);
    result.after = std::clamp(floor + 1, 0, level.blocks - 1);
    result.share_after = static_cast<float>(in_blocks - floor);
    result.from_before = static_cast<float>((in_blocks - result.before) * level.side);
    result.from_after = static_cast<float>((in_blocks - result.after) * level.side);
    return result;
  }

  void fit(const PerCell<float>& heights, const PerCell<float>& weights, const LocalPlane& top) {
    // Levels above the second are summed from the level below.
    std::vector<std::vector<BlockSum>> sums(levels_.size());
    const std::size_t summed = std::min<std::size_t>(finest_, 1);
    sums[summed] = sum_cells(levels_[summed], heights, weights);
    for (std::size_t l = summed + 1; l < levels_.size(); ++l)
      sums[l] = sum_up(levels_[l - 1], sums[l - 1], levels_[l]);
    BlockPlane expected;
    expected.height = static_cast<float>(top.height);
    expected.slope = {static_cast<float>(top.slope_x), static_cast<float>(top.slope_y)};
    expected.variance_height =
        static_cast<float>(constants::kTopHeight_m * constants::kTopHeight_m);
    expected.variance_slope.fill(static_cast<float>(constants::kTopSlope * constants::kTopSlope));
    levels_.back().planes = {corrected(expected, sums.back()[0], levels_.back().side)};
    for (std::size_t l = levels_.size() - 1; l-- > finest_;) {
      Level& level = levels_[l];
      for (int y = 0; y < level.blocks; ++y)
        for (int x = 0; x < level.blocks; ++x)
          level.planes.push_back(corrected(expectation(levels_[l + 1], level, x, y),
                                           sums[l][level.block(x, y)], level.side));
    }
  }

  [[nodiscard]] std::vector<BlockSum> sum_cells(const Level& level, const PerCell<float>& heights,
                                                const PerCell<float>& weights) const {
    std::vector<BlockSum> sums;
    for (int y = 0; y < level.blocks; ++y)
      for (int x = 0; x < level.blocks; ++x)
        sums.push_back(sum_block(level, x, y, heights, weights));
    return sums;
  }

  /// Columns first, from below, then all columns.
  [[nodiscard]] BlockSum sum_block(const Level& level, int block_x, int block_y,
                                   const PerCell<float>& heights,
                                   const PerCell<float>& weights) const {
    const auto cell_size = static_cast<float>(window_.cell_size);
    const auto first = [&](int block) {
      return (block - level.middle_block()) * level.cells - level.middle_cell() + window_.middle();
    };
    BlockSum sum;
    for (int i = 0; i < level.cells; ++i) {
      const float x = static_cast<float>(i - level.middle_cell()) * cell_size;
      BlockSum column;
      for (int k = 0; k < level.cells; ++k) {
        if (!window_.contains(first(block_x) + i, first(block_y) + k)) continue;
        const std::uint32_t cell = window_.cell(first(block_x) + i, first(block_y) + k);
        const float y = static_cast<float>(k - level.middle_cell()) * cell_size;
        const float weighted_y = weights[cell] * y;
        const float weighted_z = weights[cell] * heights[cell];
        column.w += weights[cell];
        column.y += weighted_y;
        column.yy += weighted_y * y;
        column.z += weighted_z;
        column.yz += weighted_z * y;
      }
      sum.w += column.w;
      sum.x += column.w * x;
      sum.xx += column.w * (x * x);
      sum.y += column.y;
      sum.xy += column.y * x;
      sum.yy += column.yy;
      sum.z += column.z;
      sum.xz += column.z * x;
      sum.yz += column.yz;
    }
    return sum;
  }

  /// The block of the level above that a block lies in, and its place there: -1, 0 or 1.
  struct Parent {
    int block = 0;
    int place = 0;
  };
  static Parent parent_of(const Level& fine, const Level& coarse, int block) {
    const int part = block - fine.middle_block() + coarse.middle_block() * constants::kBranch +
                     constants::kBranch / 2;
    return {part / constants::kBranch, part % constants::kBranch - constants::kBranch / 2};
  }

  /// The sums of a level from those of the level below, moved to the middles of its blocks.
  static std::vector<BlockSum> sum_up(const Level& below, const std::vector<BlockSum>& parts,
                                      const Level& level) {
    std::vector<BlockSum> sums(level.block(0, level.blocks));
    for (int row = 0; row < below.blocks; ++row) {
      const Parent in_y = parent_of(below, level, row);
      const auto y = static_cast<float>(in_y.place * below.side);
      for (int column = 0; column < below.blocks; ++column) {
        const Parent in_x = parent_of(below, level, column);
        const auto x = static_cast<float>(in_x.place * below.side);
        const BlockSum& part = parts[below.block(column, row)];
        BlockSum& sum = sums[level.block(in_x.block, in_y.block)];
        sum.w += part.w;
        sum.x += part.x + x * part.w;
        sum.y += part.y + y * part.w;
        sum.xx += part.xx + 2.0F * x * part.x + x * x * part.w;
        sum.xy += part.xy + x * part.y + y * part.x + x * y * part.w;
        sum.yy += part.yy + 2.0F * y * part.y + y * y * part.w;
        sum.z += part.z;
        sum.xz += part.xz + x * part.z;
        sum.yz += part.yz + y * part.z;
      }
    }
    return sums;
  }

  /// What the planes above say of a block: bilinear between the nearest ones, and less certain by
  /// as much as the ground may differ from them within the block.
  static BlockPlane expectation(const Level& above, const Level& level, int x, int y) {
    const Parent in_x = parent_of(level, above, x);
    const Parent in_y = parent_of(level, above, y);
    const auto neighbour = [&](const Parent& parent) {
      return std::clamp(parent.block + parent.place, 0, above.blocks - 1);
    };
    const auto along_y = [&](int column) {
      return between(above.planes[above.block(column, in_y.block)],
                     above.planes[above.block(column, neighbour(in_y))], in_y.place,
                     neighbour(in_y) - in_y.block, level.side, 1);
    };
    BlockPlane plane = between(along_y(in_x.block), along_y(neighbour(in_x)), in_x.place,
                               neighbour(in_x) - in_x.block, level.side, 0);
    const double rough = constants::kRoughness * level.side;
    plane.variance_height += static_cast<float>(rough * rough);
    for (float& variance : plane.variance_slope)
      variance += static_cast<float>(constants::kBend * constants::kBend);
    return plane;
  }

  /// Between a block's own plane above and that of its neighbour along an axis: `place` blocks of
  /// this side from the middle of the one, whose neighbour is `apart` blocks above away.
  static BlockPlane between(const BlockPlane& own, const BlockPlane& other, int place, int apart,
                            double side, std::size_t axis) {
    const auto a =
        static_cast<float>(1.0 - std::abs(place) / static_cast<double>(constants::kBranch));
    const float b = 1.0F - a;
    const auto from_own = static_cast<float>(place * side);
    const auto from_other = static_cast<float>((place - constants::kBranch * apart) * side);
    BlockPlane plane;
    plane.height = a * (own.height + own.slope[axis] * from_own) +
                   b * (other.height + other.slope[axis] * from_other);
    plane.variance_height =
        a * (own.variance_height + own.variance_slope[axis] * (from_own * from_own)) +
        b * (other.variance_height + other.variance_slope[axis] * (from_other * from_other));
    for (std::size_t i = 0; i < 2; ++i) {
      plane.slope[i] = a * own.slope[i] + b * other.slope[i];
      plane.variance_slope[i] = a * own.variance_slope[i] + b * other.variance_slope[i];
    }
    return plane;
  }

  /// The most likely plane if what was expected and the cells are right to their variances: least
  /// squares with a prior, by Cramer's rule.
  static BlockPlane corrected(const BlockPlane& plane, const BlockSum& sum, double side) {
    const double scatter = constants::kNoisePerMetre * side;
    const float per_cell =
        1.0F / static_cast<float>(constants::kNoise_m * constants::kNoise_m + scatter * scatter);
    const auto most = static_cast<float>(constants::kIndependentCells);
    const float f = per_cell * (sum.w > most ? most / sum.w : 1.0F);
    const auto [slope_x, slope_y] = plane.slope;
    const float a00 = f * sum.w + 1.0F / plane.variance_height;
    const float a01 = f * sum.x;
    const float a02 = f * sum.y;
    const float a11 = f * sum.xx + 1.0F / plane.variance_slope[0];
    const float a12 = f * sum.xy;
    const float a22 = f * sum.yy + 1.0F / plane.variance_slope[1];
    const float b0 = f * (sum.z - plane.height * sum.w - slope_x * sum.x - slope_y * sum.y);
    const float b1 = f * (sum.xz - plane.height * sum.x - slope_x * sum.xx - slope_y * sum.xy);
    const float b2 = f * (sum.yz - plane.height * sum.y - slope_x * sum.xy - slope_y * sum.yy);
    const float c00 = a11 * a22 - a12 * a12;
    const float c01 = a02 * a12 - a01 * a22;
    const float c02 = a01 * a12 - a02 * a11;
    const float c11 = a00 * a22 - a02 * a02;
    const float c12 = a01 * a02 - a00 * a12;
    const float c22 = a00 * a11 - a01 * a01;
    const float inverse = 1.0F / (a00 * c00 + a01 * c01 + a02 * c02);
    return {plane.height + (c00 * b0 + c01 * b1 + c02 * b2) * inverse,
            {slope_x + (c01 * b0 + c11 * b1 + c12 * b2) * inverse,
             slope_y + (c02 * b0 + c12 * b1 + c22 * b2) * inverse},
            c00 * inverse,
            {c11 * inverse, c22 * inverse}};
  }

  Window window_;
  std::size_t finest_ = 0;
  std::vector<Level> levels_;  // finest first
};

}  // namespace groundgrid::reference
