#pragma once

#include <algorithm>

namespace groundgrid {

/// Calls visit(column, row) for every cell of the window, ring by ring around the centre; each
/// ring starts beside its corner of least column and row and runs once around.
template <typename Visit>
void spiral(int size, int centre_column, int centre_row, const Visit& visit) {
  const auto inside = [size](int i) { return i >= 0 && i < size; };
  if (inside(centre_column) && inside(centre_row)) visit(centre_column, centre_row);
  const int rings =
      std::max({centre_column, centre_row, size - 1 - centre_column, size - 1 - centre_row});
  for (int ring = 1; ring <= rings; ++ring) {
    const int left = centre_column - ring;
    const int right = centre_column + ring;
    const int bottom = centre_row - ring;
    const int top = centre_row + ring;
    if (inside(bottom))
      for (int x = std::max(left, 0); x <= std::min(right - 1, size - 1); ++x) visit(x, bottom);
    if (inside(right))
      for (int y = std::max(bottom, 0); y <= std::min(top - 1, size - 1); ++y) visit(right, y);
    if (inside(top))
      for (int x = std::min(right, size - 1); x >= std::max(left + 1, 0); --x) visit(x, top);
    if (inside(left))
      for (int y = std::min(top, size - 1); y >= std::max(bottom + 1, 0); --y) visit(left, y);
  }
}

}  // namespace groundgrid
