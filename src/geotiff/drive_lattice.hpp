#pragma once

#include "geotiff/cell_range.hpp"
#include "geotiff/raster_grid.hpp"
#include "groundgrid/terrain_view.hpp"

namespace groundgrid::geotiff {

/// The cells of a whole drive: those of its first view, without end.
class DriveLattice {
 public:
  /// The cells of a view; one on another lattice lies at the nearest. Throws std::invalid_argument
  /// where its cells are of another size than those of the first or it is too far from that.
  CellRange window_of(const TerrainView& view);

  /// Where a raster of these cells lies.
  [[nodiscard]] RasterGrid grid_of(const CellRange& cells) const;

  [[nodiscard]] double resolution_m() const { return resolution_m_; }

 private:
  double resolution_m_ = 0.0;  // 0 until the first view has come
  double origin_x_m_ = 0.0;    // outer edges of cell (0, 0)
  double origin_y_m_ = 0.0;
};

}  // namespace groundgrid::geotiff
