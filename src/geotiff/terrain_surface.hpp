#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

#include "geotiff/cell_range.hpp"
#include "geotiff/surface_options.hpp"

namespace groundgrid::geotiff {

/// Heights of cells, row by row from the south, x fastest; NaN where there is none.
struct HeightWindow {
  explicit HeightWindow(const CellRange& window)
      : cells(window),
        heights(static_cast<std::size_t>(window.columns() * window.rows()),
                std::numeric_limits<float>::quiet_NaN()) {}

  CellRange cells;
  std::vector<float> heights;

  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>((row - cells.first_row) * cells.columns() + column -
                                    cells.first_column);
  }
};

/// Turns heights into a surface, window by window: as far as a window reaches beyond its inner
/// cells by the margin, these come out as if all the terrain had been at hand.
class TerrainSurface {
 public:
  TerrainSurface(const SurfaceOptions& options, double cell_size_m);

  /// The window that the surface over some cells depends on.
  [[nodiscard]] CellRange window_around(const CellRange& cells) const;

  /// Heights that are kept keep their bits. Throws std::runtime_error where GDAL fails.
  void complete(HeightWindow& window) const;

 private:
  struct Neighbour {
    std::int64_t columns;
    std::int64_t rows;
    float rise_m;  ///< That ground may have from there.
  };
  [[nodiscard]] bool is_raised(const HeightWindow& window, std::int64_t column,
                               std::int64_t row) const;
  void remove_raised(HeightWindow& window) const;
  void fill_gaps(HeightWindow& window) const;

  std::vector<Neighbour> neighbours_;
  std::int64_t reach_;  ///< Cells.
  double fill_;         ///< Cells.
};

}  // namespace groundgrid::geotiff
