// A surface of planes in a hierarchy of blocks; not in the paper.
#include "core/stages/plane_hierarchy.hpp"

#include <algorithm>
#include <cmath>

#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

using namespace constants;

// More tasks than this bring nothing.
constexpr int kMostBands = 8;

double square(double value) { return value * value; }

BlockScatter scatter_of(double side) {
  return {static_cast<float>(square(kRoughness * side)), static_cast<float>(square(kBend)),
          static_cast<float>(square(kNoise_m) + square(kNoisePerMetre * side)),
          static_cast<float>(kIndependentCells)};
}

/// How many blocks, each of `parts` parts a side, cover `count` parts around the middle one.
int blocks_around(int count, int parts) { return 2 * ((count / 2 + parts / 2) / parts) + 1; }

/// Place of a part in its block: -1, 0 or 1 parts from the middle.
int place_of(int part) { return part % kBranch - kBranch / 2; }

/// Linear between the middles of the two nearest blocks above, along one axis. `side` is that of
/// the part, metres.
BlockShare share_of(int part, int blocks, double side) {
  const int own = part / kBranch;
  const int place = place_of(part);
  const int other = std::clamp(own + place, 0, blocks - 1);
  return {own, other, static_cast<float>(1.0 - std::abs(place) / static_cast<double>(kBranch)),
          static_cast<float>(place * side),
          static_cast<float>((place - kBranch * (other - own)) * side)};
}

}  // namespace

PlaneHierarchy::PlaneHierarchy(int size, double resolution_m, int threads)
    : size_(size), cell_size_(resolution_m) {
  int below = size;
  int parts = kFinestBlock;
  int cells = 1;
  int cells_before = 0;
  do {
    Level& level = levels_.emplace_back();
    level.blocks = blocks_around(below, parts);
    level.before = (level.blocks * parts - below) / 2;
    cells_before += level.before * cells;
    cells *= parts;
    level.cells = cells;
    level.cells_before = cells_before;
    level.side = cells * resolution_m;
    level.sums.resize(level.row(level.blocks));
    level.planes.resize(level.row(level.blocks));
    place_cells(level);
    below = level.blocks;
    parts = kBranch;
  } while (below > 1);
  for (std::size_t l = 0; l + 1 < levels_.size(); ++l) {
    Level& level = levels_[l];
    const Level& above = levels_[l + 1];
    for (int block = 0; block < level.blocks; ++block)
      level.shares.push_back(share_of(block + above.before, above.blocks, level.side));
  }
  const auto cells_a_side = static_cast<std::size_t>(size);
  workspaces_.resize(static_cast<std::size_t>(std::clamp(threads, 1, kMostBands)));
  for (Workspace& work : workspaces_) {
    work.column_sums.resize(cells_a_side);
    work.row_weights.resize(CellRows::kMost * cells_a_side);
    for (SurfaceRow* row : {&work.cursor.lower_.surface, &work.cursor.upper_.surface}) {
      row->height.resize(cells_a_side + kRowSpare);
      row->slope_y.resize(cells_a_side + kRowSpare);
    }
  }
}

/// Where each column (and row, the same) lies between the blocks of a level.
void PlaneHierarchy::place_cells(Level& level) const {
  const int middle = size_ / 2;
  const int middle_block = level.blocks / 2;
  for (int i = 0; i < size_; ++i) {
    const double in_blocks = (i - middle) * cell_size_ / level.side + middle_block;
    const int floor = static_cast<int>(std::floor(in_blocks));
    const int before = std::clamp(floor, 0, level.blocks - 1);
    const int after = std::clamp(floor + 1, 0, level.blocks - 1);
    CellPlaces& places = level.places;
    if (i == 0 || places.runs.back().before != before || places.runs.back().after != after)
      places.runs.push_back({i, i, before, after});
    places.runs.back().end = i + 1;
    places.before.push_back(before);
    places.after.push_back(after);
    places.share_after.push_back(static_cast<float>(in_blocks - floor));
    places.from_before.push_back(static_cast<float>((in_blocks - before) * level.side));
    places.from_after.push_back(static_cast<float>((in_blocks - after) * level.side));
  }
  for (std::vector<float>* numbers :
       {&level.places.share_after, &level.places.from_before, &level.places.from_after})
    numbers->resize(numbers->size() + kRowSpare);
}

std::size_t PlaneHierarchy::level_of(double block_m) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && levels_[level].side < block_m) ++level;
  return level;
}

PlaneHierarchy::BlockRows PlaneHierarchy::rows_of(const Level& level, int block_row) const {
  const int first = block_row * level.cells - level.cells_before;
  return {std::max(first, 0), std::min(first + level.cells, size_),
          static_cast<float>(first + 0.5 * (level.cells - 1)), static_cast<float>(cell_size_)};
}

void PlaneHierarchy::sum_row_of_blocks(Level& level, int block_row,
                                       const ColumnSums& columns) const {
  sum_columns(columns, level.cells, level.cells_before, static_cast<float>(cell_size_), level.sums,
              level.row(block_row), static_cast<std::size_t>(level.blocks));
}

/// The sums of a level from those of the level below, moved to the middles of its blocks.
void PlaneHierarchy::sum_up(const Level& below, Level& level) {
  level.sums.clear();
  BlockSums& sums = level.sums;
  const BlockSums& parts = below.sums;
  for (int row = 0; row < below.blocks; ++row) {
    const int in_y = row + level.before;
    const auto y = static_cast<float>(place_of(in_y) * below.side);
    for (int column = 0; column < below.blocks; ++column) {
      const std::size_t part = below.row(row) + static_cast<std::size_t>(column);
      if (parts.w[part] == 0.0F) continue;
      const int in_x = column + level.before;
      const auto x = static_cast<float>(place_of(in_x) * below.side);
      const std::size_t block =
          level.row(in_y / kBranch) + static_cast<std::size_t>(in_x / kBranch);
      sums.w[block] += parts.w[part];
      sums.x[block] += parts.x[part] + x * parts.w[part];
      sums.y[block] += parts.y[part] + y * parts.w[part];
      sums.xx[block] += parts.xx[part] + 2.0F * x * parts.x[part] + x * x * parts.w[part];
      sums.xy[block] +=
          parts.xy[part] + x * parts.y[part] + y * parts.x[part] + x * y * parts.w[part];
      sums.yy[block] += parts.yy[part] + 2.0F * y * parts.y[part] + y * y * parts.w[part];
      sums.z[block] += parts.z[part];
      sums.xz[block] += parts.xz[part] + x * parts.z[part];
      sums.yz[block] += parts.yz[part] + y * parts.z[part];
    }
  }
}

/// The plane of the one block of the highest level.
void PlaneHierarchy::fit_top(const LocalPlane& top) {
  Level& level = levels_.back();
  BlockPlanes& planes = level.planes;
  planes.height[0] = static_cast<float>(top.height);
  planes.slope_x[0] = static_cast<float>(top.slope_x);
  planes.slope_y[0] = static_cast<float>(top.slope_y);
  planes.variance_height[0] = static_cast<float>(square(kTopHeight_m));
  planes.variance_x[0] = planes.variance_y[0] = static_cast<float>(square(kTopSlope));
  correct_row(level.sums, scatter_of(level.side), planes, 0, 1);
}

void PlaneHierarchy::fit_level(const Level& above, Level& level, TileRunner& runner) {
  const BlockScatter scatter = scatter_of(level.side);
  for_each_row_band(level.blocks, kLeastRows, runner, [&](Workspace& work, int begin, int end) {
    work.row_planes.resize(static_cast<std::size_t>(above.blocks));
    for (int row = begin; row < end; ++row) {
      const BlockShare& y = level.shares[static_cast<std::size_t>(row)];
      blend_rows(above.planes, above.row(y.own), above.row(y.other), y, work.row_planes);
      expect_row(work.row_planes, level.shares, scatter, level.planes, level.row(row));
      correct_row(level.sums, scatter, level.planes, level.row(row),
                  static_cast<std::size_t>(level.blocks));
    }
  });
}

void PlaneHierarchy::fit_planes(const LocalPlane& top, std::size_t finest, TileRunner& runner) {
  const std::size_t summed = std::min(finest, kHighestSummed);
  for (std::size_t l = summed + 1; l < levels_.size(); ++l) sum_up(levels_[l - 1], levels_[l]);
  fit_top(top);
  for (std::size_t l = levels_.size() - 1; l-- > finest;)
    fit_level(levels_[l + 1], levels_[l], runner);
  ++fits_;
}

SurfaceBetween PlaneHierarchy::surface_along(std::size_t l, std::size_t row,
                                             RowCursor& cursor) const {
  if (cursor.fit_ != fits_ || cursor.level_ != l)
    cursor.lower_.block_row = cursor.upper_.block_row = -1;
  cursor.fit_ = fits_;
  cursor.level_ = l;
  const Level& level = levels_[l];
  const CellPlaces& y = level.places;
  const auto keep = [&](int block_row, RowCursor::KeptRow& kept) {
    if (kept.block_row == block_row) return;
    kept.block_row = block_row;
    evaluate_along(level.planes, level.row(block_row), level.places, kept.surface);
  };
  if (cursor.upper_.block_row == y.before[row]) std::swap(cursor.lower_, cursor.upper_);
  keep(y.before[row], cursor.lower_);
  keep(y.after[row], cursor.upper_);
  return {&cursor.lower_.surface, &cursor.upper_.surface, y.from_before[row], y.from_after[row],
          y.share_after[row]};
}

void PlaneHierarchy::evaluate(std::size_t level, TileRunner& runner, std::span<float> surface) {
  const auto size = static_cast<std::size_t>(size_);
  for_each_row(level, runner, [&](std::size_t row, const SurfaceBetween& along) {
    evaluate_between(along, size, surface.data() + row * size);
  });
}

/// Bilinear between what at(block, x, y) says of the four blocks around a cell; x and y are the
/// cell's, from the block's middle.
template <typename At>
float PlaneHierarchy::between_blocks(const Level& level, std::size_t column, std::size_t row,
                                     const At& at) {
  const CellPlaces& places = level.places;
  const auto along_x = [&](std::int32_t block_row, float y) {
    const auto at_block = [&](std::int32_t block_column, float x) {
      return at(level.row(block_row) + static_cast<std::size_t>(block_column), x, y);
    };
    const float left = at_block(places.before[column], places.from_before[column]);
    const float right = at_block(places.after[column], places.from_after[column]);
    return left + places.share_after[column] * (right - left);
  };
  const float lower = along_x(places.before[row], places.from_before[row]);
  const float upper = along_x(places.after[row], places.from_after[row]);
  return lower + places.share_after[row] * (upper - lower);
}

/// In the order in which rows are evaluated, so that the bits are the same.
float PlaneHierarchy::height_at(std::size_t l, std::uint32_t cell) const {
  const Level& level = levels_[l];
  const BlockPlanes& planes = level.planes;
  const CellPlaces& places = level.places;
  const std::size_t column = cell % static_cast<std::size_t>(size_);
  const std::size_t row = cell / static_cast<std::size_t>(size_);
  const auto along_x = [&](std::int32_t block_row, float y) {
    const std::size_t left = level.row(block_row) + static_cast<std::size_t>(places.before[column]);
    const std::size_t right = level.row(block_row) + static_cast<std::size_t>(places.after[column]);
    const float share = places.share_after[column];
    const float from = planes.height[left] + planes.slope_x[left] * places.from_before[column];
    const float to = planes.height[right] + planes.slope_x[right] * places.from_after[column];
    const float slope_y =
        planes.slope_y[left] + share * (planes.slope_y[right] - planes.slope_y[left]);
    return from + share * (to - from) + slope_y * y;
  };
  const float lower = along_x(places.before[row], places.from_before[row]);
  const float upper = along_x(places.after[row], places.from_after[row]);
  return lower + places.share_after[row] * (upper - lower);
}

void PlaneHierarchy::evaluate_variance(std::size_t l, std::span<float> variance) const {
  const BlockPlanes& planes = levels_[l].planes;
  const auto at = [&](std::size_t block, float x, float y) {
    return planes.variance_height[block] + planes.variance_x[block] * x * x +
           planes.variance_y[block] * y * y;
  };
  const auto size = static_cast<std::size_t>(size_);
  for (std::size_t row = 0; row < size; ++row)
    for (std::size_t column = 0; column < size; ++column)
      variance[row * size + column] = between_blocks(levels_[l], column, row, at);
}

}  // namespace groundgrid
