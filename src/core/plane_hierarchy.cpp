// A surface of planes in a hierarchy of blocks; not in the paper.
#include "core/plane_hierarchy.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace groundgrid {
namespace {

constexpr int kFinestBlock = 5;  // cells a side
constexpr int kBranch = 3;       // blocks a side below each block

// How a block's plane may differ from those above it: height per metre of its side, and slope.
constexpr double kRoughness = 0.08;
constexpr double kBend = 0.08;
// And the plane of the whole square from the one expected there.
constexpr double kTopHeight_m = 0.5;
constexpr double kTopSlope = 0.1;
// Scatter of a block's cells around its plane: as measured, and per metre of its side.
constexpr double kNoise_m = 0.03;
constexpr double kNoisePerMetre = 0.03;
// The cells of a block err together: all of them say no more than this many.
constexpr double kIndependentCells = 8.0;

double square(double value) { return value * value; }

LocalPlane moved(const LocalPlane& plane, double x, double y) {
  return {plane.height + plane.slope_x * x + plane.slope_y * y, plane.slope_x, plane.slope_y};
}

void add(LocalPlane& sum, double share, const LocalPlane& plane) {
  sum.height += share * plane.height;
  sum.slope_x += share * plane.slope_x;
  sum.slope_y += share * plane.slope_y;
}

/// How many blocks, each of `parts` parts a side, cover `count` parts around the middle one.
int blocks_around(int count, int parts) { return 2 * ((count / 2 + parts / 2) / parts) + 1; }

/// Place of a part in its block: -1, 0 or 1 parts from the middle.
int place_of(int part) { return part % kBranch - kBranch / 2; }

/// One of the blocks that a block is expected to be like, and how far away its middle is.
struct Like {
  int block = 0;
  double share = 0.0;
  double away = 0.0;  ///< Sides of the block below.
};

/// Linear between the middles of the two nearest blocks above, along one axis.
std::array<Like, 2> likes(int part, int blocks) {
  const int own = part / kBranch;
  const int place = place_of(part);
  const int other = std::clamp(own + place, 0, blocks - 1);
  const double share = std::abs(place) / static_cast<double>(kBranch);
  return {{{own, 1.0 - share, static_cast<double>(place)},
           {other, share, static_cast<double>(place - kBranch * (other - own))}}};
}

}  // namespace

PlaneHierarchy::PlaneHierarchy(int size, double cell_size_m)
    : size_(size), cell_size_(cell_size_m), between_(static_cast<std::size_t>(size)) {
  int below = size;
  int parts = kFinestBlock;
  double side = cell_size_m;
  do {
    const int blocks = blocks_around(below, parts);
    const auto count = static_cast<std::size_t>(blocks) * static_cast<std::size_t>(blocks);
    side *= parts;
    levels_.push_back({blocks, (blocks * parts - below) / 2, side, std::vector<Sums>(count),
                       std::vector<BlockPlane>(count)});
    below = blocks;
    parts = kBranch;
  } while (below > 1);
  row_height_.resize(static_cast<std::size_t>(levels_.front().blocks));
  row_slope_.resize(static_cast<std::size_t>(levels_.front().blocks));
}

std::size_t PlaneHierarchy::level_of(double block_m) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && levels_[level].side < block_m) ++level;
  return level;
}

void PlaneHierarchy::sum_finest(std::span<const float> weights, std::span<const float> heights) {
  Level& level = levels_.front();
  std::fill(level.sums.begin(), level.sums.end(), Sums{});
  std::array<float, kFinestBlock> offset{};
  for (int i = 0; i < kFinestBlock; ++i)
    offset[static_cast<std::size_t>(i)] =
        (static_cast<float>(i) + 0.5F - 0.5F * static_cast<float>(kFinestBlock)) *
        static_cast<float>(cell_size_);

  for (int row = 0; row < size_; ++row) {
    const int block_row = (row + level.before) / kFinestBlock;
    const auto y =
        static_cast<double>(offset[static_cast<std::size_t>((row + level.before) % kFinestBlock)]);
    const float* weight = weights.data() + static_cast<std::ptrdiff_t>(row) * size_;
    const float* height = heights.data() + static_cast<std::ptrdiff_t>(row) * size_;
    for (int block = 0; block < level.blocks; ++block) {
      const int first = block * kFinestBlock - level.before;
      float w = 0.0F;
      float x = 0.0F;
      float xx = 0.0F;
      float z = 0.0F;
      float xz = 0.0F;
      for (int i = std::max(-first, 0); i < std::min(kFinestBlock, size_ - first); ++i) {
        const float own = weight[first + i];
        if (own == 0.0F) continue;
        const float own_x = own * offset[static_cast<std::size_t>(i)];
        w += own;
        x += own_x;
        xx += own_x * offset[static_cast<std::size_t>(i)];
        z += own * height[first + i];
        xz += own_x * height[first + i];
      }
      if (w == 0.0F) continue;
      Sums& sums = level.sums[level.index(block, block_row)];
      sums.w += static_cast<double>(w);
      sums.x += static_cast<double>(x);
      sums.y += static_cast<double>(w) * y;
      sums.xx += static_cast<double>(xx);
      sums.xy += static_cast<double>(x) * y;
      sums.yy += static_cast<double>(w) * y * y;
      sums.z += static_cast<double>(z);
      sums.xz += static_cast<double>(xz);
      sums.yz += static_cast<double>(z) * y;
    }
  }
}

/// The sums of a level from those of the level below, moved to the middles of its blocks.
void PlaneHierarchy::sum_up(const Level& below, Level& level) {
  std::fill(level.sums.begin(), level.sums.end(), Sums{});
  for (int row = 0; row < below.blocks; ++row) {
    const int in_y = row + level.before;
    const double y = place_of(in_y) * below.side;
    for (int column = 0; column < below.blocks; ++column) {
      const Sums& part = below.sums[below.index(column, row)];
      if (part.w == 0.0) continue;
      const int in_x = column + level.before;
      const double x = place_of(in_x) * below.side;
      Sums& sums = level.sums[level.index(in_x / kBranch, in_y / kBranch)];
      sums.w += part.w;
      sums.x += part.x + x * part.w;
      sums.y += part.y + y * part.w;
      sums.xx += part.xx + 2.0 * x * part.x + x * x * part.w;
      sums.xy += part.xy + x * part.y + y * part.x + x * y * part.w;
      sums.yy += part.yy + 2.0 * y * part.y + y * y * part.w;
      sums.z += part.z;
      sums.xz += part.xz + x * part.z;
      sums.yz += part.yz + y * part.z;
    }
  }
}

/// What the planes above say of a block: bilinear between those of the nearest blocks.
PlaneHierarchy::BlockPlane PlaneHierarchy::expected(const Level& above, double side, int column,
                                                    int row) {
  BlockPlane sum;
  for (const Like& y : likes(row + above.before, above.blocks)) {
    for (const Like& x : likes(column + above.before, above.blocks)) {
      const double share = x.share * y.share;
      if (share == 0.0) continue;
      const BlockPlane& from = above.planes[above.index(x.block, y.block)];
      const double east = x.away * side;
      const double north = y.away * side;
      add(sum.plane, share, moved(from.plane, east, north));
      add(sum.variance, share, moved(from.variance, east * east, north * north));
    }
  }
  sum.variance.height += square(kRoughness * side);
  sum.variance.slope_x += square(kBend);
  sum.variance.slope_y += square(kBend);
  return sum;
}

/// The most likely plane after a look at the block's own cells, by Cramer's rule.
PlaneHierarchy::BlockPlane PlaneHierarchy::corrected(const BlockPlane& expected, const Sums& sums,
                                                     double side) {
  if (sums.w == 0.0) return expected;
  const double noise = square(kNoise_m) + square(kNoisePerMetre * side);
  const double f = std::min(1.0, kIndependentCells / sums.w) / noise;
  const LocalPlane& plane = expected.plane;
  // Normal equations of the correction: a symmetric matrix, its right side, its cofactors.
  const double a00 = f * sums.w + 1.0 / expected.variance.height;
  const double a01 = f * sums.x;
  const double a02 = f * sums.y;
  const double a11 = f * sums.xx + 1.0 / expected.variance.slope_x;
  const double a12 = f * sums.xy;
  const double a22 = f * sums.yy + 1.0 / expected.variance.slope_y;
  const double b0 =
      f * (sums.z - plane.height * sums.w - plane.slope_x * sums.x - plane.slope_y * sums.y);
  const double b1 =
      f * (sums.xz - plane.height * sums.x - plane.slope_x * sums.xx - plane.slope_y * sums.xy);
  const double b2 =
      f * (sums.yz - plane.height * sums.y - plane.slope_x * sums.xy - plane.slope_y * sums.yy);
  const double c00 = a11 * a22 - a12 * a12;
  const double c01 = a02 * a12 - a01 * a22;
  const double c02 = a01 * a12 - a02 * a11;
  const double c11 = a00 * a22 - a02 * a02;
  const double c12 = a01 * a02 - a00 * a12;
  const double c22 = a00 * a11 - a01 * a01;
  const double determinant = a00 * c00 + a01 * c01 + a02 * c02;
  return {{plane.height + (c00 * b0 + c01 * b1 + c02 * b2) / determinant,
           plane.slope_x + (c01 * b0 + c11 * b1 + c12 * b2) / determinant,
           plane.slope_y + (c02 * b0 + c12 * b1 + c22 * b2) / determinant},
          {c00 / determinant, c11 / determinant, c22 / determinant}};
}

void PlaneHierarchy::fit(std::span<const float> weights, std::span<const float> heights,
                         const LocalPlane& top, std::size_t finest) {
  sum_finest(weights, heights);
  for (std::size_t l = 1; l < levels_.size(); ++l) sum_up(levels_[l - 1], levels_[l]);
  const BlockPlane highest{top, {square(kTopHeight_m), square(kTopSlope), square(kTopSlope)}};
  for (std::size_t l = levels_.size(); l-- > finest;) {
    Level& level = levels_[l];
    for (int row = 0; row < level.blocks; ++row) {
      for (int column = 0; column < level.blocks; ++column) {
        const std::size_t block = level.index(column, row);
        const BlockPlane before =
            l + 1 == levels_.size() ? highest : expected(levels_[l + 1], level.side, column, row);
        level.planes[block] = corrected(before, level.sums[block], level.side);
      }
    }
  }
}

/// Where each column (and row, the same) lies between the blocks of a level.
void PlaneHierarchy::place_cells(const Level& level) {
  const int middle = size_ / 2;
  const int middle_block = level.blocks / 2;
  for (int i = 0; i < size_; ++i) {
    const double in_blocks = (i - middle) * cell_size_ / level.side + middle_block;
    const int floor = static_cast<int>(std::floor(in_blocks));
    const int before = std::clamp(floor, 0, level.blocks - 1);
    const int after = std::clamp(floor + 1, 0, level.blocks - 1);
    between_[static_cast<std::size_t>(i)] = {static_cast<std::size_t>(before),
                                             static_cast<std::size_t>(after),
                                             static_cast<float>(in_blocks - floor),
                                             static_cast<float>((in_blocks - before) * level.side),
                                             static_cast<float>((in_blocks - after) * level.side)};
  }
}

void PlaneHierarchy::evaluate(std::size_t l, std::span<float> surface) {
  const Level& level = levels_[l];
  place_cells(level);
  const auto blocks = static_cast<std::size_t>(level.blocks);
  const auto columns = static_cast<std::size_t>(size_);
  for (std::size_t row = 0; row < columns; ++row) {
    const Between& y = between_[row];
    const BlockPlane* before = level.planes.data() + y.before * blocks;
    const BlockPlane* after = level.planes.data() + y.after * blocks;
    const auto share = static_cast<double>(y.share_after);
    for (std::size_t b = 0; b < blocks; ++b) {
      const LocalPlane lower = moved(before[b].plane, 0.0, static_cast<double>(y.from_before));
      const LocalPlane upper = moved(after[b].plane, 0.0, static_cast<double>(y.from_after));
      row_height_[b] = static_cast<float>(lower.height + share * (upper.height - lower.height));
      row_slope_[b] = static_cast<float>(lower.slope_x + share * (upper.slope_x - lower.slope_x));
    }
    float* out = surface.data() + row * columns;
    for (std::size_t column = 0; column < columns; ++column) {
      const Between& x = between_[column];
      const float left = row_height_[x.before] + row_slope_[x.before] * x.from_before;
      const float right = row_height_[x.after] + row_slope_[x.after] * x.from_after;
      out[column] = left + x.share_after * (right - left);
    }
  }
}

void PlaneHierarchy::evaluate_variance(std::size_t l, std::span<float> variance) {
  const Level& level = levels_[l];
  place_cells(level);
  const auto columns = static_cast<std::size_t>(size_);
  const auto at = [&level](std::size_t column, std::size_t row, float x, float y) {
    const LocalPlane& own =
        level.planes[row * static_cast<std::size_t>(level.blocks) + column].variance;
    return static_cast<float>(
        moved(own, square(static_cast<double>(x)), square(static_cast<double>(y))).height);
  };
  for (std::size_t row = 0; row < columns; ++row) {
    const Between& y = between_[row];
    for (std::size_t column = 0; column < columns; ++column) {
      const Between& x = between_[column];
      const auto along_x = [&](std::size_t block_row, float from) {
        const float left = at(x.before, block_row, x.from_before, from);
        return left + x.share_after * (at(x.after, block_row, x.from_after, from) - left);
      };
      const float lower = along_x(y.before, y.from_before);
      variance[row * columns + column] =
          lower + y.share_after * (along_x(y.after, y.from_after) - lower);
    }
  }
}

}  // namespace groundgrid
