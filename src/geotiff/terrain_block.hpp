#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "geotiff/cell_range.hpp"
#include "geotiff/terrain_raster.hpp"

namespace groundgrid::geotiff {

/// What a terrain raster says of one cell, band by band; kNoData where it says nothing.
struct TerrainPixel {
  float height = kNoData;
  float confidence = kNoData;
  float count = kNoData;
  float density = kNoData;
};

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
    const auto first =
        static_cast<std::size_t>((cells_.end_row - 1 - row) * kSide + column - cells_.first_column);
    pixels_[first] = pixel.height;
    pixels_[first + kPixels] = pixel.confidence;
    pixels_[first + 2 * kPixels] = pixel.count;
    pixels_[first + 3 * kPixels] = pixel.density;
  }

  /// The pixels of a band, counted from 0, as GDAL wants them.
  float* band(int index) { return pixels_.data() + static_cast<std::size_t>(index) * kPixels; }

 private:
  static constexpr std::size_t kPixels = std::size_t{kSide} * kSide;

  CellRange cells_;
  std::vector<float> pixels_;
};

}  // namespace groundgrid::geotiff
