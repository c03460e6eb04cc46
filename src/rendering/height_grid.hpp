#pragma once

#include <cstddef>
#include <vector>

namespace groundgrid::rendering {

/// Heights of cells whose sides run from west to east and from north to south.
struct HeightGrid {
  int columns = 0;
  int rows = 0;
  double west_m = 0.0;   ///< Outer edge of the first column.
  double north_m = 0.0;  ///< Outer edge of the first row.
  double cell_width_m = 0.0;
  double cell_height_m = 0.0;
  std::vector<float> heights_m{};  ///< Row by row from the north; NaN where there is none.

  [[nodiscard]] double width_m() const { return columns * cell_width_m; }
  [[nodiscard]] double height_m() const { return rows * cell_height_m; }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
  [[nodiscard]] float at(int column, int row) const { return heights_m[index(column, row)]; }
};

/// The least part of a grid that holds all its heights; empty where there are none.
HeightGrid cropped(const HeightGrid& grid);

/// The grid with cells so much larger that neither side has more than `most` of them; each is the
/// mean of those in it that have a height.
HeightGrid coarsened(const HeightGrid& grid, int most);

/// The values below and above which each one of `share` of the finite numbers lies; 0 and 0 where
/// there are none.
struct ValueRange {
  double low = 0.0;
  double high = 0.0;
};
ValueRange range_of(std::vector<float> values, double share);

}  // namespace groundgrid::rendering
