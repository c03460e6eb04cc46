#include "geotiff/terrain_raster.hpp"

#include <cstdint>
#include <vector>

#include "core/map/cell_statistics.hpp"
#include "geotiff/crs.hpp"
#include "geotiff/point_density.hpp"
#include "geotiff/terrain_file.hpp"
#include "geotiff/view_check.hpp"

namespace groundgrid::geotiff {
namespace {

float height_of(const TerrainView& terrain, std::size_t cell) {
  return static_cast<float>(terrain.z_origin_m +
                            static_cast<double>(terrain.relative_height[cell]));
}

void fill(TerrainBlock& block, const TerrainView& terrain,
          const std::vector<std::uint32_t>& points_around) {
  const double area_m2 = density_area_m2(terrain.resolution_m);
  const CellRange cells = overlap(block.cells(), {0, terrain.size, 0, terrain.size});
  for (std::int64_t row = cells.first_row; row < cells.end_row; ++row) {
    for (std::int64_t column = cells.first_column; column < cells.end_column; ++column) {
      const auto cell = static_cast<std::size_t>(row * terrain.size + column);
      const bool known = terrain.confidence[cell] > 0.0F;
      if (!known && points_around[cell] == 0) continue;
      TerrainPixel pixel{
          .count = static_cast<float>(terrain.statistics[cell].count),
          .density = static_cast<float>(static_cast<double>(points_around[cell]) / area_m2)};
      if (known) {
        pixel.height = height_of(terrain, cell);
        pixel.confidence = terrain.confidence[cell];
      }
      block.set(column, row, pixel);
    }
  }
}

HeightWindow heights_of(const TerrainView& terrain, const CellRange& cells) {
  HeightWindow window(cells);
  const CellRange inside = overlap(cells, {0, terrain.size, 0, terrain.size});
  for (std::int64_t row = inside.first_row; row < inside.end_row; ++row) {
    for (std::int64_t column = inside.first_column; column < inside.end_column; ++column) {
      const auto cell = static_cast<std::size_t>(row * terrain.size + column);
      if (terrain.confidence[cell] > 0.0F)
        window.heights[window.index(column, row)] = height_of(terrain, cell);
    }
  }
  return window;
}

}  // namespace

void check_crs(const std::string& crs) { (void)read_crs(crs); }

void write_terrain(const std::filesystem::path& path, const TerrainView& terrain,
                   const std::string& crs, const std::optional<SurfaceOptions>& surface) {
  const std::optional<OGRSpatialReference> reference = read_crs(crs);
  check_view(terrain);
  if (terrain.size == 0) fail_without_terrain(path);
  TerrainFile file(
      path, {terrain.min_x_m, terrain.min_y_m, terrain.resolution_m, terrain.size, terrain.size},
      reference);
  std::vector<std::uint32_t> points_around;
  count_points_around(terrain, points_around);
  TerrainSurface completion(surface, terrain.resolution_m);
  TerrainBlock block;
  for (int row = 0; row < file.block_rows(); ++row) {
    for (int column = 0; column < file.block_columns(); ++column) {
      block.move_to(file.cells_of(column, row));
      fill(block, terrain, points_around);
      HeightWindow window = heights_of(terrain, completion.window_around(block.cells()));
      completion.complete(window);
      block.take_heights(window);
      file.write(column, row, block);
    }
  }
  file.commit();
}

}  // namespace groundgrid::geotiff
