#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace groundgrid {

/// Weighted sums over the cells of each block, one array a sum; x and y from the block's middle,
/// metres.
struct BlockSums {
  std::vector<float> w{}, x{}, y{}, xx{}, xy{}, yy{}, z{}, xz{}, yz{};

  void resize(std::size_t blocks) {
    for (std::vector<float>* sum : {&w, &x, &y, &xx, &xy, &yy, &z, &xz, &yz}) sum->resize(blocks);
  }
  void clear() {
    for (std::vector<float>* sum : {&w, &x, &y, &xx, &xy, &yy, &z, &xz, &yz})
      std::fill(sum->begin(), sum->end(), 0.0F);
  }
};

/// Each block's plane from its middle, and the variances of its three numbers; one array a number.
struct BlockPlanes {
  std::vector<float> height{}, slope_x{}, slope_y{};
  std::vector<float> variance_height{}, variance_x{}, variance_y{};

  void resize(std::size_t blocks) {
    for (std::vector<float>* number :
         {&height, &slope_x, &slope_y, &variance_height, &variance_x, &variance_y})
      number->resize(blocks);
  }
};

/// Weighted sums over the cells of each column of some rows; y from a line of the caller's choice.
struct ColumnSums {
  std::vector<float> w{}, wy{}, wyy{}, z{}, zy{};

  void resize(std::size_t columns) {
    for (std::vector<float>* sum : {&w, &wy, &wyy, &z, &zy}) sum->resize(columns);
  }
  void clear() {
    for (std::vector<float>* sum : {&w, &wy, &wyy, &z, &zy})
      std::fill(sum->begin(), sum->end(), 0.0F);
  }
};

/// The two blocks above that a block is expected to be like, along one axis: linear between their
/// middles.
struct BlockShare {
  std::int32_t own = 0;
  std::int32_t other = 0;
  float share = 0.0F;       ///< Of the own one.
  float away = 0.0F;        ///< Metres from the middle of the own one,
  float away_other = 0.0F;  ///< and from that of the other.
};

/// How far a block's plane may be from what is expected, and its cells from it.
struct BlockScatter {
  float variance_height = 0.0F;  ///< m²
  float variance_slope = 0.0F;
  float variance_cell = 0.0F;      ///< m²
  float independent_cells = 0.0F;  ///< All cells of a block say no more than this many.
};

/// A few rows of cells.
struct CellRows {
  static constexpr std::size_t kMost = 5;
  std::size_t count = 0;
  const float* weights[kMost] = {};
  const float* heights[kMost] = {};
  float y[kMost] = {};  ///< Metres.
};

/// Adds rows of `count` cells to the sums of their columns.
void add_rows(const CellRows& rows, std::size_t count, ColumnSums& sums);

/// Sums of columns to sums of a row of `count` blocks of cells × cells, the first of which begins
/// `cells_before` columns early; written to `row` on.
void sum_columns(const ColumnSums& columns, int cells, int cells_before, float cell_size,
                 BlockSums& sums, std::size_t row, std::size_t count);

/// The planes of two rows of blocks, bilinear at the y of a row of blocks below them.
void blend_rows(const BlockPlanes& planes, std::size_t own_row, std::size_t other_row,
                const BlockShare& share, BlockPlanes& at_y);

/// What those planes say of each block of the row below; written to `row` on.
void expect_row(const BlockPlanes& at_y, std::span<const BlockShare> shares,
                const BlockScatter& scatter, BlockPlanes& planes, std::size_t row);

/// Corrects the planes of `count` blocks from `row` on by the sums over their cells: the most
/// likely planes, by Cramer's rule.
void correct_row(const BlockSums& sums, const BlockScatter& scatter, BlockPlanes& planes,
                 std::size_t row, std::size_t count);

/// Cells [begin, end) of a row between the middles of the same two blocks.
struct CellRun {
  std::int32_t begin = 0;
  std::int32_t end = 0;
  std::int32_t before = 0;  ///< The blocks.
  std::int32_t after = 0;
};

/// So many numbers more than cells are in the arrays of a row, for vectors that begin in it.
constexpr std::size_t kRowSpare = 64;

/// Where the middles of cells lie between the middles of two blocks, along one axis; one array a
/// number, with room to spare.
struct CellPlaces {
  std::vector<CellRun> runs{};
  std::vector<std::int32_t> before{}, after{};
  std::vector<float> share_after{};
  std::vector<float> from_before{}, from_after{};  ///< Metres from the blocks' middles.
};

/// A surface along a row of cells whose y is that of a row of blocks, and its slope along y; with
/// room to spare.
struct SurfaceRow {
  std::vector<float> height{};
  std::vector<float> slope_y{};
};

/// The surface along a row of blocks, linear between the planes from `row` on.
void evaluate_along(const BlockPlanes& planes, std::size_t row, const CellPlaces& places,
                    SurfaceRow& surface);

/// The surface along a row of cells: linear between the rows of blocks below and above it.
struct SurfaceBetween {
  const SurfaceRow* lower = nullptr;
  const SurfaceRow* upper = nullptr;
  float from_lower = 0.0F;  ///< Metres.
  float from_upper = 0.0F;
  float share_upper = 0.0F;
};

/// That surface at `count` cells.
void evaluate_between(const SurfaceBetween& between, std::size_t count, float* surface);

}  // namespace groundgrid
