#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geotiff/cell_range.hpp"
#include "geotiff/raster_grid.hpp"
#include "geotiff/terrain_raster.hpp"
#include "geotiff/terrain_surface.hpp"

namespace groundgrid::geotiff {

/// What a terrain raster says of one cell, band by band; kNoData where it says nothing.
struct TerrainPixel {
  float height = kNoData;
  float confidence = kNoData;
  float count = kNoData;
  float density = kNoData;
};

/// The band, counted from 0, that comes from the finished surface and not from the scans.
inline constexpr std::size_t kDeviationBand = 4;

/// One block of a terrain raster with all its bands. GeoTIFF wants row 0 in the north; here cells
/// keep the numbers that they have on their lattice, with row 0 in the south.
class TerrainBlock {
 public:
  static constexpr int kSide = 256;

  TerrainBlock() : pixels_(kTerrainBands * kPixels) {}

  /// Takes the block to other cells, kSide × kSide of them, of which nothing is known.
  void move_to(const CellRange& cells) {
    cells_ = cells;
    std::fill(pixels_.begin(), pixels_.end(), kNoData);
  }

  [[nodiscard]] const CellRange& cells() const { return cells_; }

  void set(std::int64_t column, std::int64_t row, const TerrainPixel& pixel) {
    const std::size_t first = index(column, row);
    pixels_[first] = pixel.height;
    pixels_[first + kPixels] = pixel.confidence;
    pixels_[first + 2 * kPixels] = pixel.count;
    pixels_[first + 3 * kPixels] = pixel.density;
  }

  /// Takes the heights of a surface and their deviations. Confidence is that of a height which a
  /// scan showed, so it is 0 where the surface says another one. False where it has none in this
  /// block.
  bool take_heights(const HeightWindow& surface) {
    bool any = false;
    for (std::int64_t row = cells_.first_row; row < cells_.end_row; ++row) {
      for (std::int64_t column = cells_.first_column; column < cells_.end_column; ++column) {
        const std::size_t pixel = index(column, row);
        const std::size_t cell = surface.index(column, row);
        any = take_height(pixel, surface.heights[cell]) || any;
        const float deviation = surface.deviations[cell];
        pixels_[pixel + kDeviationBand * kPixels] = std::isnan(deviation) ? kNoData : deviation;
      }
    }
    return any;
  }

  /// The pixels of a band, counted from 0, as GDAL wants them.
  float* band(int index) { return pixels_.data() + static_cast<std::size_t>(index) * kPixels; }

 private:
  static constexpr std::size_t kPixels = std::size_t{kSide} * kSide;

  [[nodiscard]] std::size_t index(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>((cells_.end_row - 1 - row) * kSide + column -
                                    cells_.first_column);
  }

  bool take_height(std::size_t pixel, float height) {
    const bool known = !std::isnan(height);
    if (known && pixels_[pixel] == height) return true;
    pixels_[pixel] = known ? height : kNoData;
    pixels_[pixel + kPixels] = known ? 0.0F : kNoData;
    return known;
  }

  CellRange cells_;
  std::vector<float> pixels_;
};

inline std::int64_t blocks_over(std::int64_t cells) {
  return (cells + TerrainBlock::kSide - 1) / TerrainBlock::kSide;
}

/// The cells under a block of a raster, block row 0 in the north, counted from the raster's
/// south-western corner; in the last block of a row or column some lie outside the raster.
inline CellRange cells_of_block(const RasterGrid& grid, std::int64_t block_column,
                                std::int64_t block_row) {
  const std::int64_t column = block_column * TerrainBlock::kSide;
  const std::int64_t end_row = grid.rows - block_row * TerrainBlock::kSide;
  return {column, column + TerrainBlock::kSide, end_row - TerrainBlock::kSide, end_row};
}

}  // namespace groundgrid::geotiff
