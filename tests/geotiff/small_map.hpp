#pragma once

#include <cmath>
#include <cstddef>
#include <random>
#include <vector>

#include "core/map/cell_statistics.hpp"

namespace groundgrid::test {

/// A map made by hand; every cell begins unknown, with a height that must never be read.
struct SmallMap {
  explicit SmallMap(int cells, double cell_size = 0.5)
      : size(cells),
        resolution_m(cell_size),
        height(static_cast<std::size_t>(cells * cells), NAN),
        confidence(height.size(), 0.0F),
        statistics(height.size()) {}

  void set(int column, int row, float relative_height, float certainty, std::uint32_t points = 0) {
    const auto cell = static_cast<std::size_t>(row * size + column);
    height[cell] = relative_height;
    confidence[cell] = certainty;
    statistics[cell].count = points;
  }

  [[nodiscard]] TerrainView view() const {
    TerrainView view;
    view.size = size;
    view.resolution_m = resolution_m;
    view.min_x_m = min_x_m;
    view.min_y_m = min_y_m;
    view.z_origin_m = z_origin_m;
    view.relative_height = height;
    view.confidence = confidence;
    view.statistics = statistics.data();
    return view;
  }

  int size;
  double resolution_m;
  double min_x_m = 0.0;
  double min_y_m = 0.0;
  double z_origin_m = 0.0;
  std::vector<float> height;
  std::vector<float> confidence;
  std::vector<CellStatistics> statistics;
};

/// A map all of whose cells are known, different in every cell and for every seed.
inline SmallMap noisy_map(int size, double min_x_m, double min_y_m, unsigned seed) {
  SmallMap map(size);
  map.min_x_m = min_x_m;
  map.min_y_m = min_y_m;
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> height(-3.0F, 3.0F);
  std::uniform_real_distribution<float> confidence(0.1F, 1.0F);
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column)
      map.set(column, row, height(random), confidence(random),
              static_cast<std::uint32_t>(random() % 1000));
  return map;
}

}  // namespace groundgrid::test
