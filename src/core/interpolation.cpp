// Terrain interpolation, paper III-E.
#include "core/interpolation.hpp"

#include <algorithm>

namespace groundgrid {
namespace {

/// Calls visit(column, row) for every cell of the window, ring by ring around the centre; each
/// ring starts beside its corner of least column and row and runs once around.
template <typename Visit>
void spiral(int size, int centre_column, int centre_row, const Visit& visit) {
  const auto inside = [size](int i) { return i >= 0 && i < size; };
  if (inside(centre_column) && inside(centre_row)) visit(centre_column, centre_row);
  const int rings =
      std::max({centre_column, centre_row, size - 1 - centre_column, size - 1 - centre_row});
  for (int ring = 1; ring <= rings; ++ring) {
    const int left = centre_column - ring;
    const int right = centre_column + ring;
    const int bottom = centre_row - ring;
    const int top = centre_row + ring;
    if (inside(bottom))
      for (int x = std::max(left, 0); x <= std::min(right - 1, size - 1); ++x) visit(x, bottom);
    if (inside(right))
      for (int y = std::max(bottom, 0); y <= std::min(top - 1, size - 1); ++y) visit(right, y);
    if (inside(top))
      for (int x = std::min(right, size - 1); x >= std::max(left + 1, 0); --x) visit(x, top);
    if (inside(left))
      for (int y = std::min(top, size - 1); y >= std::max(bottom + 1, 0); --y) visit(left, y);
  }
}

}  // namespace

void interpolate(const std::vector<std::uint8_t>& is_ground, int sensor_column, int sensor_row,
                 const Config& config, ElevationMap& map) {
  const int size = map.size();
  float* height = map.height().data();
  float* confidence = map.confidence().data();
  const auto decay = static_cast<float>(config.confidence_decay);

  spiral(size, sensor_column, sensor_row, [&](int column, int row) {
    const auto cell = static_cast<std::size_t>(row * size + column);
    if (is_ground[cell] != 0) return;
    float sum_confidence = 0.0F;
    float sum_weighted = 0.0F;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, size - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size - 1); ++x) {
        const auto neighbour = static_cast<std::size_t>(y * size + x);
        sum_confidence += confidence[neighbour];
        sum_weighted += confidence[neighbour] * height[neighbour];
      }
    }
    height[cell] =
        interpolated_height(height[cell], confidence[cell], sum_confidence, sum_weighted);
    confidence[cell] = decayed_confidence(confidence[cell], decay);
  });
}

}  // namespace groundgrid
