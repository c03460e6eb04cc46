#include "rendering/map_picture.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/scale_bar.hpp"

namespace groundgrid::rendering {
namespace {

constexpr Color kUncovered{176, 176, 176};

/// Where the metres of a map go on a plot that shows all of it.
class MapView {
 public:
  MapView(const Rectangle& plot, const HeightGrid& grid)
      : pixels_per_m_(std::min(plot.width / grid.width_m(), plot.height / grid.height_m())),
        west_m_(grid.west_m),
        north_m_(grid.north_m),
        area_{plot.middle().x - pixels_per_m_ * grid.width_m() / 2.0,
              plot.middle().y - pixels_per_m_ * grid.height_m() / 2.0,
              pixels_per_m_ * grid.width_m(), pixels_per_m_ * grid.height_m()} {}

  [[nodiscard]] double pixels_per_m() const { return pixels_per_m_; }
  [[nodiscard]] const Rectangle& area() const { return area_; }
  [[nodiscard]] PixelPoint place(const MapPoint& point) const {
    return {area_.x + (point.x_m - west_m_) * pixels_per_m_,
            area_.y + (north_m_ - point.y_m) * pixels_per_m_};
  }

 private:
  double pixels_per_m_;
  double west_m_;
  double north_m_;
  Rectangle area_;
};

void draw_path(Figure& figure, const MapView& view, const std::vector<MapPoint>& path) {
  if (path.empty()) return;
  std::vector<PixelPoint> line(path.size());
  std::transform(path.begin(), path.end(), line.begin(),
                 [&view](const MapPoint& point) { return view.place(point); });
  const double width = std::max(1.5, 0.16 * figure.font_px());
  figure.canvas().line(line, {.color = kPathEdge, .width_px = 2.0 * width});
  figure.canvas().line(line, {.color = kPath, .width_px = width});
  figure.canvas().disc(line.front(), 2.4 * width, kPathEdge);
  figure.canvas().disc(line.front(), 1.6 * width, kPath);
}

Image draw_map(Figure& figure, const HeightGrid& grid, const Image& cells,
               const std::vector<MapPoint>& path) {
  const MapView view(figure.plot(), grid);
  fill_no_data(figure.canvas(), figure.plot(), figure.font_px());
  figure.canvas().clip(figure.plot());
  figure.canvas().paste(cells, view.area());
  draw_path(figure, view, path);
  figure.canvas().unclip();
  draw_scale_bar(figure.canvas(), figure.plot(), view.pixels_per_m(), figure.font_px());
  draw_up_arrow(figure.canvas(), figure.plot(), "north", figure.font_px());
  return figure.finish();
}

void add_path_entry(std::vector<LegendEntry>& legend, const std::vector<MapPoint>& path) {
  if (!path.empty())
    legend.push_back(
        {.text = "path of the vehicle, from the dot", .color = kPath, .mark = LegendMark::line});
}

}  // namespace

Color terrain_color(const ValueRange& heights_m, double height_m, double light) {
  const double span = std::max(heights_m.high - heights_m.low, 1e-6);
  const Color color = height_colors().at((height_m - heights_m.low) / span);
  if (light <= 1.0) return mix(kBlack, color, std::clamp(0.15 + 0.85 * light, 0.0, 1.0));
  return mix(color, kWhite, std::clamp(0.8 * (light - 1.0), 0.0, 1.0));
}

Image draw_terrain_from_above(const TerrainPicture& picture, ImageSize size) {
  const HeightGrid& grid = picture.grid;
  Image cells{.size = {grid.columns, grid.rows}};
  for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
    const auto height = static_cast<double>(grid.heights_m[i]);
    const double light = static_cast<double>(picture.shade[i]) / picture.level_shade;
    cells.pixels.push_back(std::isnan(height)
                               ? kTransparent
                               : pixel_of(terrain_color(picture.heights_m, height, light)));
  }
  std::vector<LegendEntry> legend{{.text = "no data", .mark = LegendMark::no_data}};
  add_path_entry(legend, picture.path);
  Figure figure(size, {.title = picture.title,
                       .caption = picture.caption,
                       .legend = legend,
                       .bar = ColorBar{&height_colors(), picture.heights_m.low,
                                       picture.heights_m.high, "height (m)"}});
  return draw_map(figure, grid, cells, picture.path);
}

Image draw_errors(const ErrorPicture& picture, ImageSize size) {
  const HeightGrid& grid = picture.errors;
  Image cells{.size = {grid.columns, grid.rows}};
  for (std::size_t i = 0; i < grid.heights_m.size(); ++i) {
    const auto error = static_cast<double>(grid.heights_m[i]);
    const std::uint32_t without =
        std::isnan(picture.reference.heights_m[i]) ? kTransparent : pixel_of(kUncovered);
    cells.pixels.push_back(std::isnan(error)
                               ? without
                               : pixel_of(error_colors().at(0.5 + 0.5 * error / picture.limit_m)));
  }
  std::vector<LegendEntry> legend{
      {.text = "no estimate", .color = kUncovered, .mark = LegendMark::box},
      {.text = "no reference", .mark = LegendMark::no_data}};
  add_path_entry(legend, picture.path);
  Figure figure(size, {.title = picture.title,
                       .caption = picture.caption,
                       .legend = legend,
                       .bar = ColorBar{&error_colors(), -picture.limit_m, picture.limit_m,
                                       "estimate \u2212 reference (m)"}});
  return draw_map(figure, grid, cells, picture.path);
}

ImageSize map_size(double width_m, double height_m) {
  constexpr double kPixels = 1.2e6;
  constexpr double kFlattest = 2.5;
  const double aspect = std::clamp(width_m / height_m, 1.0 / kFlattest, kFlattest);
  return {static_cast<int>(std::lround(std::sqrt(kPixels * aspect))),
          static_cast<int>(std::lround(std::sqrt(kPixels / aspect)))};
}

}  // namespace groundgrid::rendering
