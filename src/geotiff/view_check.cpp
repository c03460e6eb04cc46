#include "geotiff/view_check.hpp"

#include <cmath>
#include <stdexcept>

namespace groundgrid::geotiff {

void check_view(const TerrainView& view) {
  const auto cells = static_cast<std::size_t>(view.size) * static_cast<std::size_t>(view.size);
  if (view.size < 0 || view.confidence.size() != cells || view.relative_height.size() != cells ||
      (cells > 0 && view.statistics == nullptr))
    throw std::invalid_argument("TerrainView: every layer must have size x size cells");
  if (view.size > 0 && !(view.resolution_m > 0.0 && std::isfinite(view.resolution_m)))
    throw std::invalid_argument("TerrainView: resolution_m must be positive");
  if (!std::isfinite(view.min_x_m) || !std::isfinite(view.min_y_m))
    throw std::invalid_argument("TerrainView: min_x_m and min_y_m must be finite");
}

}  // namespace groundgrid::geotiff
