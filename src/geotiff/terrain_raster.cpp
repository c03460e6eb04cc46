#include "geotiff/terrain_raster.hpp"

#include "geotiff/crs.hpp"
#include "geotiff/terrain_file.hpp"
#include "geotiff/view_check.hpp"

namespace groundgrid::geotiff {
namespace {

void fill(TerrainBlock& block, const TerrainView& terrain) {
  const CellRange cells = overlap(block.cells(), {0, terrain.size, 0, terrain.size});
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column) {
      const auto cell = static_cast<std::size_t>(row * terrain.size + column);
      if (!(terrain.confidence[cell] > 0.0F)) continue;
      const double height = terrain.z_origin_m + static_cast<double>(terrain.relative_height[cell]);
      block.set(column, row, static_cast<float>(height), terrain.confidence[cell],
                static_cast<float>(terrain.statistics[cell].count));
    }
  }
}

}  // namespace

void check_crs(const std::string& crs) { (void)read_crs(crs); }

void write_terrain(const std::filesystem::path& path, const TerrainView& terrain,
                   const std::string& crs) {
  const std::optional<OGRSpatialReference> reference = read_crs(crs);
  check_view(terrain);
  if (terrain.size == 0) fail_without_terrain(path);
  TerrainFile file(
      path, {terrain.min_x_m, terrain.min_y_m, terrain.cell_size_m, terrain.size, terrain.size},
      reference);
  TerrainBlock block;
  for (int row = 0; row < file.block_rows(); ++row) {
    for (int column = 0; column < file.block_columns(); ++column) {
      block.move_to(file.cells_of(column, row));
      fill(block, terrain);
      file.write(column, row, block);
    }
  }
  file.commit();
}

}  // namespace groundgrid::geotiff
