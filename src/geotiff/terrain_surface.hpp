#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <vector>

#include "core/stages/surface_fit.hpp"
#include "geotiff/cell_range.hpp"
#include "geotiff/surface_options.hpp"

namespace groundgrid::geotiff {

/// Heights of cells and their standard deviations, metres, row by row from the south, x fastest;
/// NaN where there is none.
struct HeightWindow {
  explicit HeightWindow(const CellRange& window)
      : cells(window),
        heights(static_cast<std::size_t>(window.columns() * window.rows()),
                std::numeric_limits<float>::quiet_NaN()),
        deviations(heights) {}

  CellRange cells;
  std::vector<float> heights;
  std::vector<float> deviations;

  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return index_in(cells, column, row);
  }
};

/// Turns heights into a surface, window by window: as far as a window reaches beyond its inner
/// cells by the margin, these come out as if all the terrain had been at hand, but for millimetres,
/// and centimetres where they are far from any known one.
class TerrainSurface {
 public:
  /// Without options all heights stay and no gap is filled: only deviations are told.
  TerrainSurface(const std::optional<SurfaceOptions>& options, double resolution_m);

  /// The window that the surface over some cells depends on.
  [[nodiscard]] CellRange window_around(const CellRange& cells) const;

  /// Takes out what stands on the terrain, fills gaps and tells the deviations. Heights that are
  /// kept keep their bits.
  void complete(HeightWindow& window);

 private:
  struct Neighbour {
    std::int64_t columns;
    std::int64_t rows;
    float rise_m;  ///< That ground may have from there.
  };
  [[nodiscard]] bool is_raised(const HeightWindow& window, std::int64_t column,
                               std::int64_t row) const;
  void remove_raised(HeightWindow& window) const;
  void fit(HeightWindow& window);
  [[nodiscard]] bool is_known(const HeightWindow& window, std::int64_t column,
                              std::int64_t row) const;
  [[nodiscard]] bool is_rim(const HeightWindow& window, std::int64_t column,
                            std::int64_t row) const;
  void spread_known(const HeightWindow& window);
  void make_room(const HeightWindow& window);
  [[nodiscard]] std::size_t in_square(const HeightWindow& window, std::int64_t column,
                                      std::int64_t row) const {
    return static_cast<std::size_t>((row - window.cells.first_row) * side_ + column -
                                    window.cells.first_column);
  }

  double resolution_m_;
  bool completes_;
  std::vector<Neighbour> neighbours_;
  std::int64_t reach_ = 0;  // cells
  double fill_ = 0.0;       // cells
  // The window as a square of an odd number of cells, as planes want it.
  std::int64_t side_ = 0;
  TileRunner runner_{1};
  std::optional<SurfaceFit> planes_;
  std::vector<float> heights_;        // above the first known one
  std::vector<std::uint32_t> known_;  // cells of the square with a height, ascending
  std::vector<float> deviations_;
  std::vector<float> surface_;
  std::vector<std::uint8_t> near_;  // of gaps: whether within `fill_` of a known cell
};

}  // namespace groundgrid::geotiff
