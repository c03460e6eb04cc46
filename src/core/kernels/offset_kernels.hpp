#pragma once

#include <cstddef>
#include <cstdint>

namespace groundgrid {

/// What each cell of a square adds to the mean height of the ground points around. Two cells that
/// add nothing stand between the rows and before the first one, and two rows of them at either end,
/// so that the cells around any cell can be read, and some more.
struct OffsetGrid {
  static constexpr std::size_t kMargin = 2;
  static constexpr std::size_t kSpare = 64;

  const float* weights = nullptr;         ///< Points.
  const float* weighted_steps = nullptr;  ///< Their height over the map, steps times points.
  std::size_t size = 0;

  /// Where cell `cell` (row by row, without margins), which is in this row, is found.
  [[nodiscard]] static std::size_t place(std::size_t size, std::size_t cell, std::size_t row) {
    return cell + kMargin * row + kMargin * (size + kMargin) + kMargin;
  }
  /// How many numbers there must be of each kind.
  [[nodiscard]] static std::size_t places(std::size_t size) {
    return (size + 2 * kMargin) * (size + kMargin) + 2 * kMargin + kSpare;
  }
};

/// A row of cells whose levels are raised.
struct LevelRow {
  const std::uint8_t* is_occupied = nullptr;  ///< Of each cell; 1 where it has points.
  const float* heights = nullptr;             ///< Of the map, metres.
  float* limits = nullptr;                    ///< Level and threshold of each cell.
};

/// Sets the levels of a row's occupied cells (those of others may change, too) to the map's heights
/// raised by the mean height of the ground points in the 5 × 5 cells around. The cell itself counts
/// three times, "no offset" like three points.
void raise_levels(const OffsetGrid& grid, std::size_t row, float step_m, const LevelRow& cells);

}  // namespace groundgrid
