#pragma once

#include <cstddef>

namespace groundgrid::evaluation {

/// Cells in rows, the layers over them row by row. Whether rows count to the north or to the south
/// makes no difference to any figure.
struct CellLattice {
  int columns = 0;
  int rows = 0;
  double cell_width_m = 0.0;   ///< Along a row.
  double cell_height_m = 0.0;  ///< From row to row.

  [[nodiscard]] std::size_t cells() const {
    return static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows);
  }
  [[nodiscard]] std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
           static_cast<std::size_t>(column);
  }
};

}  // namespace groundgrid::evaluation
