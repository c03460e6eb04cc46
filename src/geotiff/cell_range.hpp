#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace groundgrid::geotiff {

/// Cells of a lattice with first_column <= column < end_column, rows likewise. Columns count
/// along x, rows along y (north).
struct CellRange {
  std::int64_t first_column = 0;
  std::int64_t end_column = 0;
  std::int64_t first_row = 0;
  std::int64_t end_row = 0;

  [[nodiscard]] bool empty() const { return first_column >= end_column || first_row >= end_row; }
  [[nodiscard]] std::int64_t columns() const { return end_column - first_column; }
  [[nodiscard]] std::int64_t rows() const { return end_row - first_row; }
};

inline CellRange overlap(const CellRange& a, const CellRange& b) {
  return {std::max(a.first_column, b.first_column), std::min(a.end_column, b.end_column),
          std::max(a.first_row, b.first_row), std::min(a.end_row, b.end_row)};
}

/// The smallest range that holds both.
inline CellRange hull(const CellRange& a, const CellRange& b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.first_column, b.first_column), std::max(a.end_column, b.end_column),
          std::min(a.first_row, b.first_row), std::max(a.end_row, b.end_row)};
}

inline CellRange moved(const CellRange& range, std::int64_t columns, std::int64_t rows) {
  return {range.first_column + columns, range.end_column + columns, range.first_row + rows,
          range.end_row + rows};
}

/// Place of a cell among those of a range, row by row, x fastest.
inline std::size_t index_in(const CellRange& cells, std::int64_t column, std::int64_t row) {
  return static_cast<std::size_t>((row - cells.first_row) * cells.columns() + column -
                                  cells.first_column);
}

}  // namespace groundgrid::geotiff
