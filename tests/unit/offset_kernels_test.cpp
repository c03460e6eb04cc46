#include "core/kernels/offset_kernels.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <random>
#include <vector>

#include "support/instruction_sets.hpp"

namespace groundgrid {
namespace {

/// A square of cells, half of them with ground points, and the levels of its cells.
struct OffsetSquare {
  std::size_t size;
  std::vector<float> weights;
  std::vector<float> weighted;
  std::vector<float> heights;
  std::vector<std::uint8_t> is_occupied;
  std::vector<float> limits;

  explicit OffsetSquare(std::size_t cells_along)
      : size(cells_along),
        weights(OffsetGrid::places(size)),
        weighted(OffsetGrid::places(size)),
        heights(size * size),
        is_occupied(size * size),
        limits(2 * size * size, -9.0F) {
    std::mt19937 random(1);
    for (std::size_t row = 0; row < size; ++row)
      for (std::size_t column = 0; column < size; ++column) {
        const std::size_t cell = row * size + column;
        const auto points = static_cast<float>(random() % 2 == 0 ? 0 : random() % 30);
        offer(column, row, points, points * (static_cast<float>(random() % 2001) - 1000.0F));
        heights[cell] = static_cast<float>(random() % 10);
        // Some stretches of a row are empty.
        is_occupied[cell] = column / 20 % 2 == 0 && random() % 3 != 0 ? 1 : 0;
      }
  }
  void offer(std::size_t column, std::size_t row, float points, float steps) {
    const std::size_t place = OffsetGrid::place(size, row * size + column, row);
    weights[place] = points;
    weighted[place] = steps;
  }
  void raise(std::size_t row, float step_m) {
    raise_levels({weights.data(), weighted.data(), size}, row, step_m,
                 {is_occupied.data() + row * size, heights.data() + row * size,
                  limits.data() + 2 * row * size});
  }
  [[nodiscard]] float level(std::size_t column, std::size_t row) const {
    return limits[2 * (row * size + column)];
  }

  /// Σ w·h over the 5 × 5 cells, the own one three times, over Σ w + 3.
  [[nodiscard]] double mean(std::size_t column, std::size_t row) const {
    double sum = 0.0;
    double weight = 3.0;
    for (std::size_t y = row - std::min<std::size_t>(row, 2); y <= std::min(row + 2, size - 1); ++y)
      for (std::size_t x = column - std::min<std::size_t>(column, 2);
           x <= std::min(column + 2, size - 1); ++x) {
        const std::size_t place = OffsetGrid::place(size, y * size + x, y);
        const double times = y == row && x == column ? 3.0 : 1.0;
        sum += times * static_cast<double>(weighted[place]);
        weight += times * static_cast<double>(weights[place]);
      }
    return sum / weight;
  }
};

class OffsetKernels : public testing::OnInstructionSet {};

TEST_P(OffsetKernels, RaiseLevelsAtBordersAndInside) {
  constexpr float kStep_m = 0.5F;
  for (const std::size_t size : {1U, 3U, 5U, 31U, 127U, 128U, 129U, 263U}) {
    OffsetSquare square(size);
    for (std::size_t row = 0; row < size; ++row) {
      square.raise(row, kStep_m);
      for (std::size_t column = 0; column < size; ++column) {
        const std::size_t cell = row * size + column;
        EXPECT_EQ(square.limits[2 * cell + 1], -9.0F) << "the threshold";
        if (square.is_occupied[cell] == 0) continue;
        EXPECT_NEAR(static_cast<double>(square.level(column, row)),
                    static_cast<double>(square.heights[cell]) + 0.5 * square.mean(column, row),
                    1e-2)
            << size << ": " << column << ", " << row;
      }
    }
  }
}

TEST_P(OffsetKernels, RaiseLevelsOfOneRowOnly) {
  OffsetSquare square(40);
  square.raise(7, 1.0F);
  for (std::size_t row = 0; row < 40; ++row)
    for (std::size_t column = 0; column < (row == 7 ? 0U : 40U); ++column)
      EXPECT_EQ(square.level(column, row), -9.0F) << column << ", " << row;
}

TEST_P(OffsetKernels, LonePointCountsThreeTimesInItsCellAndOnceAround) {
  OffsetSquare square(9);
  for (std::size_t cell = 0; cell < 81; ++cell) square.offer(cell % 9, cell / 9, 0.0F, 0.0F);
  square.offer(4, 4, 1.0F, 60.0F);
  std::fill(square.heights.begin(), square.heights.end(), 0.0F);
  std::fill(square.is_occupied.begin(), square.is_occupied.end(), std::uint8_t{1});
  // 60 / (3 + 1) = 15 two cells away; 3 · 60 / (3 + 3) = 30 in the cell.
  const std::vector<float> expected{0, 0, 15, 15, 30, 15, 15, 0, 0};
  square.raise(4, 1.0F);
  square.raise(7, 1.0F);
  for (std::size_t column = 0; column < 9; ++column) {
    EXPECT_EQ(square.level(column, 4), expected[column]) << column;
    EXPECT_EQ(square.level(column, 7), 0.0F) << column;
  }
}

INSTANTIATE_TEST_SUITE_P(With, OffsetKernels, testing::all_instruction_sets(), testing::name_of);

}  // namespace
}  // namespace groundgrid
