#include "rendering/terrain_view.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/nice_numbers.hpp"

namespace groundgrid::rendering {
namespace {

/// Turns a grid into the corners and triangles of its cells, about its own middle.
class TerrainMesh {
 public:
  TerrainMesh(const TerrainPicture& picture, double exaggeration)
      : picture_(picture), grid_(picture.grid), exaggeration_(exaggeration) {}

  void add_cells(Scene& scene) const {
    for (int row = 0; row < grid_.rows; ++row)
      for (int column = 0; column < grid_.columns; ++column)
        if (!std::isnan(grid_.at(column, row))) add_cell(scene, column, row);
  }

  void add_path(Scene& scene) const {
    const double dot_m = std::max(grid_.width_m(), grid_.height_m()) / 160.0;
    for (std::size_t i = 1; i < picture_.path.size(); ++i) {
      const MapPoint& from = picture_.path[i - 1];
      const MapPoint& to = picture_.path[i];
      const double length = std::hypot(to.x_m - from.x_m, to.y_m - from.y_m);
      const int dots = std::clamp(static_cast<int>(4.0 * length / dot_m), 1, 1000);
      for (int dot = 0; dot < dots; ++dot) add_dot(scene, from, to, 1.0 * dot / dots, dot_m);
    }
  }

 private:
  [[nodiscard]] double lifted(double height_m) const {
    const double middle = 0.5 * (picture_.heights_m.low + picture_.heights_m.high);
    return exaggeration_ * (height_m - middle);
  }

  // The mean of the up to four cells that meet there.
  [[nodiscard]] double corner_height(int column, int row) const {
    double sum = 0.0;
    int count = 0;
    for (int y = std::max(row - 1, 0); y <= std::min(row, grid_.rows - 1); ++y)
      for (int x = std::max(column - 1, 0); x <= std::min(column, grid_.columns - 1); ++x) {
        const auto height = static_cast<double>(grid_.at(x, y));
        if (std::isnan(height)) continue;
        sum += height;
        ++count;
      }
    return sum / count;
  }

  [[nodiscard]] Vertex corner(int column, int row, Color color) const {
    return {.x = static_cast<float>(column * grid_.cell_width_m - grid_.width_m() / 2.0),
            .y = static_cast<float>(grid_.height_m() / 2.0 - row * grid_.cell_height_m),
            .z = static_cast<float>(lifted(corner_height(column, row))),
            .color = color};
  }

  void add_cell(Scene& scene, int column, int row) const {
    const std::size_t index = grid_.index(column, row);
    const Color color =
        terrain_color(picture_.heights_m, static_cast<double>(grid_.heights_m[index]),
                      static_cast<double>(picture_.shade[index]) / picture_.level_shade);
    const auto first = static_cast<std::uint32_t>(scene.corners.size());
    for (const std::array<int, 2> step :
         {std::array{0, 0}, std::array{1, 0}, std::array{1, 1}, std::array{0, 1}})
      scene.corners.push_back(corner(column + step[0], row + step[1], color));
    for (const std::uint32_t next : {0U, 1U, 2U, 0U, 2U, 3U})
      scene.triangles.push_back(first + next);
  }

  void add_dot(Scene& scene, const MapPoint& from, const MapPoint& to, double fraction,
               double size_m) const {
    const double x = from.x_m + fraction * (to.x_m - from.x_m);
    const double y = from.y_m + fraction * (to.y_m - from.y_m);
    const double column = (x - grid_.west_m) / grid_.cell_width_m;
    const double row = (grid_.north_m - y) / grid_.cell_height_m;
    if (column < 0.0 || column >= grid_.columns || row < 0.0 || row >= grid_.rows) return;
    const auto height =
        static_cast<double>(grid_.at(static_cast<int>(column), static_cast<int>(row)));
    if (std::isnan(height)) return;
    const auto east = static_cast<float>(x - grid_.west_m - grid_.width_m() / 2.0);
    const auto north = static_cast<float>(y - grid_.north_m + grid_.height_m() / 2.0);
    const auto up = static_cast<float>(lifted(height));
    const auto size = static_cast<float>(size_m);
    scene.points.push_back({east, north, up + size, size, kPath});
    // Farther down, so that it shows as an edge only.
    scene.points.push_back({east, north, up + 0.5F * size, 1.7F * size, kPathEdge});
  }

  const TerrainPicture& picture_;
  const HeightGrid& grid_;
  double exaggeration_;
};

Camera camera_over(const Scene& scene, const ViewPoint& view, double aspect) {
  // A few thousand corners tell how large the whole is.
  const std::size_t step = 1 + scene.corners.size() / 5000;
  std::vector<Eigen::Vector3d> places;
  for (std::size_t i = 0; i < scene.corners.size(); i += step)
    places.emplace_back(scene.corners[i].x, scene.corners[i].y, scene.corners[i].z);
  return camera_around(view, places, Eigen::Vector3d::UnitY(), aspect);
}

}  // namespace

double fitting_exaggeration(const TerrainPicture& picture) {
  constexpr double kRelief = 0.08;  // Of the terrain's longer side.
  constexpr double kGreatest = 10.0;
  const double side = std::max(picture.grid.width_m(), picture.grid.height_m());
  const double relief = std::max(picture.heights_m.high - picture.heights_m.low, 1e-3);
  return std::clamp(nice_below(kRelief * side / relief), 1.0, kGreatest);
}

Image draw_terrain_in_perspective(const PerspectiveRenderer& renderer,
                                  const TerrainPicture& picture, const ViewPoint& view,
                                  double exaggeration, ImageSize size) {
  std::vector<LegendEntry> legend;
  if (!picture.path.empty())
    legend.push_back({.text = "path of the vehicle", .color = kPath, .mark = LegendMark::line});
  Figure figure(size, {.title = picture.title,
                       .caption = picture.caption,
                       .legend = legend,
                       .bar = ColorBar{&height_colors(), picture.heights_m.low,
                                       picture.heights_m.high, "height (m)"}});
  const TerrainMesh mesh(picture, exaggeration);
  Scene scene{.depth_shading = 2.0};
  mesh.add_cells(scene);
  mesh.add_path(scene);
  const ImageSize inner{static_cast<int>(figure.plot().width),
                        static_cast<int>(figure.plot().height)};
  const Camera camera = camera_over(scene, view, static_cast<double>(inner.width) / inner.height);
  figure.canvas().paste(renderer.draw(scene, camera, inner), figure.plot());
  return figure.finish();
}

}  // namespace groundgrid::rendering
