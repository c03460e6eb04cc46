#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "rendering/figure.hpp"
#include "rendering/height_grid.hpp"

namespace groundgrid::rendering {

/// A place on a map, metres.
struct MapPoint {
  double x_m = 0.0;  ///< To the east.
  double y_m = 0.0;  ///< To the north.
  double z_m = 0.0;  ///< Up.
};

/// A terrain to be drawn from above.
struct TerrainPicture {
  HeightGrid grid{};
  std::vector<std::uint8_t> shade{};  ///< How light each cell is, 1 to 255; level ground is
                                      ///< `level_shade`.
  std::uint8_t level_shade = 180;
  ValueRange heights_m{};        ///< What the ends of the colours stand for.
  std::vector<MapPoint> path{};  ///< Of the vehicle; may be empty.
  std::string title{};
  std::string caption{};
};

/// Errors of a terrain to be drawn from above.
struct ErrorPicture {
  HeightGrid errors{};     ///< Metres; NaN where there is none.
  HeightGrid reference{};  ///< The true heights of the same cells; NaN where there is none.
  double limit_m = 1.0;    ///< What the ends of the colours stand for.
  std::vector<MapPoint> path{};
  std::string title{};
  std::string caption{};
};

/// Hillshaded heights, north up, with a colour bar, the path and a scale bar. Cells without a
/// height are hatched.
Image draw_terrain_from_above(const TerrainPicture& picture, ImageSize size);

/// Errors, north up, blue where the estimate is too low and red where it is too high.
Image draw_errors(const ErrorPicture& picture, ImageSize size);

/// A size of usual area for a map of that shape.
ImageSize map_size(double width_m, double height_m);

/// The colour of a height, lit.
Color terrain_color(const ValueRange& heights_m, double height_m, double light);

inline constexpr Color kPath{255, 255, 255};
inline constexpr Color kPathEdge{20, 20, 20};

}  // namespace groundgrid::rendering
