#include "rendering/height_grid.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace groundgrid::rendering {
namespace {

struct CellBox {
  int west = std::numeric_limits<int>::max();
  int east = -1;
  int north = std::numeric_limits<int>::max();
  int south = -1;
};

CellBox box_of_heights(const HeightGrid& grid) {
  CellBox box;
  for (int row = 0; row < grid.rows; ++row)
    for (int column = 0; column < grid.columns; ++column) {
      if (std::isnan(grid.at(column, row))) continue;
      box = {std::min(box.west, column), std::max(box.east, column), std::min(box.north, row),
             std::max(box.south, row)};
    }
  return box;
}

float mean_of_block(const HeightGrid& grid, int west, int north, int side) {
  double sum = 0.0;
  int count = 0;
  for (int row = north; row < std::min(north + side, grid.rows); ++row)
    for (int column = west; column < std::min(west + side, grid.columns); ++column) {
      const auto height = static_cast<double>(grid.at(column, row));
      if (std::isnan(height)) continue;
      sum += height;
      ++count;
    }
  return count == 0 ? std::numeric_limits<float>::quiet_NaN() : static_cast<float>(sum / count);
}

}  // namespace

HeightGrid cropped(const HeightGrid& grid) {
  const CellBox box = box_of_heights(grid);
  if (box.east < 0) return {};
  HeightGrid part{.columns = box.east - box.west + 1,
                  .rows = box.south - box.north + 1,
                  .west_m = grid.west_m + box.west * grid.cell_width_m,
                  .north_m = grid.north_m - box.north * grid.cell_height_m,
                  .cell_width_m = grid.cell_width_m,
                  .cell_height_m = grid.cell_height_m};
  for (int row = box.north; row <= box.south; ++row)
    for (int column = box.west; column <= box.east; ++column)
      part.heights_m.push_back(grid.at(column, row));
  return part;
}

HeightGrid coarsened(const HeightGrid& grid, int most) {
  const int side = (std::max(grid.columns, grid.rows) + most - 1) / most;
  if (side <= 1) return grid;
  HeightGrid coarse{.columns = (grid.columns + side - 1) / side,
                    .rows = (grid.rows + side - 1) / side,
                    .west_m = grid.west_m,
                    .north_m = grid.north_m,
                    .cell_width_m = side * grid.cell_width_m,
                    .cell_height_m = side * grid.cell_height_m};
  for (int row = 0; row < coarse.rows; ++row)
    for (int column = 0; column < coarse.columns; ++column)
      coarse.heights_m.push_back(mean_of_block(grid, column * side, row * side, side));
  return coarse;
}

ValueRange range_of(std::vector<float> values, double share) {
  values.erase(std::remove_if(values.begin(), values.end(),
                              [](float value) { return !std::isfinite(value); }),
               values.end());
  if (values.empty()) return {};
  const auto nth = [&values](double place) {
    const auto index =
        static_cast<std::ptrdiff_t>(std::lround(place * static_cast<double>(values.size() - 1)));
    std::nth_element(values.begin(), values.begin() + index, values.end());
    return static_cast<double>(values[static_cast<std::size_t>(index)]);
  };
  return {nth(share), nth(1.0 - share)};
}

}  // namespace groundgrid::rendering
