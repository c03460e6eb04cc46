#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/kernels/plane_kernels.hpp"
#include "core/parallel.hpp"

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
  /// The surface along the two rows of blocks beside a row of cells, kept from one row to the next.
  /// Each task that reads the surface has one of its own.
  class RowCursor {
    friend class PlaneHierarchy;
    struct KeptRow {
      int block_row = -1;
      SurfaceRow surface{};
    };
    std::size_t fit_ = 0;  // the number of the fit that the rows are of
    std::size_t level_ = 0;
    KeptRow lower_{};
    KeptRow upper_{};
  };

  /// For `size` × `size` cells, an odd number, and tasks of at most so many threads.
  PlaneHierarchy(int size, double resolution_m, int threads);

  /// The finest level whose blocks are at least this wide; 0 is 5 × 5 cells.
  [[nodiscard]] std::size_t level_of(double block_m) const;

  /// Fits the planes of all levels down to `finest` to heights of cells (row by row, metres, finite
  /// even where the weight is 0). weigh(row, cursor, weights) writes the weights of a row of cells,
  /// 0 to 1; with the cursor surface_along() tells it of the planes of the fit before. `top` is the
  /// plane expected at the middle.
  template <typename Weigh>
  void fit(std::span<const float> heights, const Weigh& weigh, const LocalPlane& top,
           std::size_t finest, TileRunner& runner) {
    Level& level = levels_[std::min(finest, kHighestSummed)];
    const int least_rows = std::max(kLeastCellRows / level.cells, 1);
    for_each_row_band(level.blocks, least_rows, runner, [&](Workspace& work, int begin, int end) {
      for (int block_row = begin; block_row < end; ++block_row) {
        work.column_sums.clear();
        add_block_row(heights, weigh, rows_of(level, block_row), work);
        sum_row_of_blocks(level, block_row, work.column_sums);
      }
    });
    fit_planes(top, finest, runner);
  }

  /// The surface along the middles of a row of cells, bilinear between the planes of a level. Valid
  /// until the next call with this cursor; rows one after the other cost least.
  [[nodiscard]] SurfaceBetween surface_along(std::size_t level, std::size_t row,
                                             RowCursor& cursor) const;

  /// Calls visit(row, surface along it) for every row of cells, some rows on each thread.
  template <typename Visit>
  void for_each_row(std::size_t level, TileRunner& runner, const Visit& visit) {
    for_each_row_band(size_, kLeastCellRows, runner, [&](Workspace& work, int begin, int end) {
      for (auto row = static_cast<std::size_t>(begin); row < static_cast<std::size_t>(end); ++row)
        visit(row, surface_along(level, row, work.cursor));
    });
  }

  /// The surface at the middle of every cell.
  void evaluate(std::size_t level, TileRunner& runner, std::span<float> surface);

  /// The same of one cell.
  [[nodiscard]] float height_at(std::size_t level, std::uint32_t cell) const;

  /// The variance of that height at each cell, m²: bilinear between those of the planes.
  void evaluate_variance(std::size_t level, std::span<float> variance) const;

 private:
  struct Level {
    int blocks = 0;  ///< A side, an odd number.
    int before = 0;  ///< Blocks (or cells) of the level below by which the first begins early.
    int cells = 0;   ///< Of a block, a side.
    int cells_before = 0;  ///< Cells by which the first block begins before the square.
    double side = 0.0;     ///< Of a block, metres.
    BlockSums sums{};
    BlockPlanes planes{};
    std::vector<BlockShare> shares{};  ///< Per block of a row: in the level above.
    CellPlaces places{};               ///< Of the square's columns (and rows, the same).

    [[nodiscard]] std::size_t row(int block_row) const {
      return static_cast<std::size_t>(block_row) * static_cast<std::size_t>(blocks);
    }
  };
  /// The rows of cells of a row of blocks.
  struct BlockRows {
    int begin = 0;
    int end = 0;
    float middle = 0.0F;  ///< Of the blocks, rows.
    float cell_size = 0.0F;

    [[nodiscard]] float y_of(int row) const {
      return (static_cast<float>(row) - middle) * cell_size;
    }
  };
  /// What a task needs for itself.
  struct Workspace {
    ColumnSums column_sums{};
    std::vector<float> row_weights{};  // of CellRows::kMost rows
    BlockPlanes row_planes{};          // of a row of a level above, at the y of a row below
    RowCursor cursor{};
  };
  // Beyond some cells a side single precision would lose digits in the sums over columns: higher
  // levels are summed from the level below.
  static constexpr std::size_t kHighestSummed = 1;
  // Fewer rows of blocks, or of cells, than this are not worth another task.
  static constexpr int kLeastRows = 16;
  static constexpr int kLeastCellRows = 64;

  /// Calls task(workspace, begin, end) for bands of rows. No row depends on how they are cut.
  template <typename Task>
  void for_each_row_band(int rows, int least_rows, TileRunner& runner, const Task& task) {
    const int most = std::min(runner.threads(), static_cast<int>(workspaces_.size()));
    const int bands = std::clamp(rows / least_rows, 1, most);
    runner.parallel_for_tiles(static_cast<std::size_t>(bands), [&](std::size_t band) {
      const auto begin = [&](std::size_t b) { return rows * static_cast<int>(b) / bands; };
      task(workspaces_[band], begin(band), begin(band + 1));
    });
  }

  /// Adds the cells of a row of blocks to the sums over its columns.
  template <typename Weigh>
  void add_block_row(std::span<const float> heights, const Weigh& weigh, const BlockRows& in_block,
                     Workspace& work) const {
    const auto size = static_cast<std::size_t>(size_);
    CellRows rows;
    for (int row = in_block.begin; row < in_block.end; ++row) {
      const auto cell_row = static_cast<std::size_t>(row);
      float* weights = work.row_weights.data() + rows.count * size;
      weigh(cell_row, work.cursor, weights);
      rows.weights[rows.count] = weights;
      rows.heights[rows.count] = heights.data() + cell_row * size;
      rows.y[rows.count] = in_block.y_of(row);
      if (++rows.count < CellRows::kMost && row + 1 < in_block.end) continue;
      add_rows(rows, size, work.column_sums);
      rows.count = 0;
    }
  }

  template <typename At>
  static float between_blocks(const Level& level, std::size_t column, std::size_t row,
                              const At& at);
  void place_cells(Level& level) const;
  [[nodiscard]] BlockRows rows_of(const Level& level, int block_row) const;
  void sum_row_of_blocks(Level& level, int block_row, const ColumnSums& columns) const;
  static void sum_up(const Level& below, Level& level);
  void fit_planes(const LocalPlane& top, std::size_t finest, TileRunner& runner);
  void fit_top(const LocalPlane& top);
  void fit_level(const Level& above, Level& level, TileRunner& runner);

  int size_;
  double cell_size_;
  std::size_t fits_ = 0;       // how many there were
  std::vector<Level> levels_;  // finest first
  std::vector<Workspace> workspaces_;
};

}  // namespace groundgrid
