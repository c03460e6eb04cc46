#include "geotiff/terrain_surface.hpp"

#include <cpl_string.h>
#include <gdal_alg.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "geotiff/gdal_errors.hpp"
#include "geotiff/geotiff_driver.hpp"

namespace groundgrid::geotiff {
namespace {

// Passes of a mean over 3×3 cells through what was filled. GDAL's own weights leave steps; with
// so many passes a gap in a slope is filled along it.
constexpr int kSmoothing = 30;

void check(const GdalErrors& errors, bool succeeded) {
  if (!succeeded) throw std::runtime_error("gaps in the terrain: " + errors.first());
}

}  // namespace

TerrainSurface::TerrainSurface(const SurfaceOptions& options, double cell_size_m)
    : reach_(std::llround(options.reach_m / cell_size_m)), fill_(options.fill_m / cell_size_m) {
  for (std::int64_t rows = -reach_; rows <= reach_; ++rows) {
    for (std::int64_t columns = -reach_; columns <= reach_; ++columns) {
      const double distance = std::hypot(static_cast<double>(columns), static_cast<double>(rows));
      if (distance == 0.0 || distance > static_cast<double>(reach_)) continue;
      const double rise = options.step_m + options.max_slope * distance * cell_size_m;
      neighbours_.push_back({columns, rows, static_cast<float>(rise)});
    }
  }
  // Near ones decide most often.
  std::sort(neighbours_.begin(), neighbours_.end(),
            [](const Neighbour& a, const Neighbour& b) { return a.rise_m < b.rise_m; });
}

CellRange TerrainSurface::window_around(const CellRange& cells) const {
  const std::int64_t margin = reach_ + static_cast<std::int64_t>(std::ceil(fill_)) + kSmoothing;
  return {cells.first_column - margin, cells.end_column + margin, cells.first_row - margin,
          cells.end_row + margin};
}

void TerrainSurface::complete(HeightWindow& window) const {
  remove_raised(window);
  if (fill_ > 0.0) fill_gaps(window);
}

bool TerrainSurface::is_raised(const HeightWindow& window, std::int64_t column,
                               std::int64_t row) const {
  const float height = window.heights[window.index(column, row)];
  if (std::isnan(height)) return false;
  return std::any_of(neighbours_.begin(), neighbours_.end(), [&](const Neighbour& to) {
    const std::int64_t x = column + to.columns;
    const std::int64_t y = row + to.rows;
    return x >= window.cells.first_column && x < window.cells.end_column &&
           y >= window.cells.first_row && y < window.cells.end_row &&
           height > window.heights[window.index(x, y)] + to.rise_m;
  });
}

void TerrainSurface::remove_raised(HeightWindow& window) const {
  std::vector<std::size_t> raised;
  for (std::int64_t row = window.cells.first_row; row < window.cells.end_row; ++row)
    for (std::int64_t column = window.cells.first_column; column < window.cells.end_column;
         ++column)
      if (is_raised(window, column, row)) raised.push_back(window.index(column, row));
  for (const std::size_t cell : raised) window.heights[cell] = std::nanf("");
}

void TerrainSurface::fill_gaps(HeightWindow& window) const {
  const auto is_known = [](float height) { return !std::isnan(height); };
  if (std::none_of(window.heights.begin(), window.heights.end(), is_known)) return;
  std::vector<std::uint8_t> known(window.heights.size());
  std::transform(window.heights.begin(), window.heights.end(), known.begin(), is_known);
  const int columns = static_cast<int>(window.cells.columns());
  const int rows = static_cast<int>(window.cells.rows());
  const GdalErrors errors;
  const DatasetPtr heights(memory_driver().Create("", columns, rows, 1, GDT_Float32, nullptr));
  const DatasetPtr mask(memory_driver().Create("", columns, rows, 1, GDT_Byte, nullptr));
  check(errors, heights != nullptr && mask != nullptr);
  GDALRasterBand& band = *heights->GetRasterBand(1);
  GDALRasterBand& mask_band = *mask->GetRasterBand(1);
  const auto transfer = [&](GDALRWFlag direction) {
    check(errors, band.RasterIO(direction, 0, 0, columns, rows, window.heights.data(), columns,
                                rows, GDT_Float32, 0, 0, nullptr) == CE_None);
  };
  transfer(GF_Write);
  check(errors, mask_band.RasterIO(GF_Write, 0, 0, columns, rows, known.data(), columns, rows,
                                   GDT_Byte, 0, 0, nullptr) == CE_None);
  CPLStringList options;
  options.SetNameValue("TEMP_FILE_DRIVER", "MEM");
  check(errors, GDALFillNodata(&band, &mask_band, fill_, 0, kSmoothing, options.List(), nullptr,
                               nullptr) == CE_None);
  transfer(GF_Read);
}

}  // namespace groundgrid::geotiff
