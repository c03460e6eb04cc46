#include "rendering/scan_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "rendering/nice_numbers.hpp"

namespace groundgrid::rendering {
namespace {

constexpr Color kRangeRing{196, 196, 196};
constexpr float kPointSize_m = 0.065F;
constexpr int kRings = 5;

double ring_step(const ScanPicture& picture) { return nice_below(picture.range_m / 4.0); }

void add_points(Scene& scene, const ScanPicture& picture) {
  for (std::size_t i = 0; i < picture.group.size(); ++i) {
    if (picture.group[i] >= picture.styles.size()) continue;
    const PointStyle& style = picture.styles[picture.group[i]];
    const float* const place = &picture.coordinates[3 * i];
    if (!std::isfinite(place[0] + place[1] + place[2])) continue;
    scene.points.push_back({.x = place[0],
                            .y = place[1],
                            .z = place[2],
                            .size_m = kPointSize_m * static_cast<float>(style.size),
                            .color = style.color});
  }
}

void add_rings(Scene& scene, const ScanPicture& picture) {
  constexpr double kSpacing_m = 0.1;
  const double step = ring_step(picture);
  for (int ring = 1; ring <= kRings; ++ring) {
    const int dots = static_cast<int>(2.0 * std::numbers::pi * ring * step / kSpacing_m);
    for (int i = 0; i < dots; ++i) {
      const double angle = 2.0 * std::numbers::pi * i / dots;
      scene.points.push_back({.x = static_cast<float>(ring * step * std::cos(angle)),
                              .y = static_cast<float>(ring * step * std::sin(angle)),
                              .z = -static_cast<float>(picture.sensor_height_m),
                              .color = kRangeRing});
    }
  }
}

// An arrow head on the ground that looks ahead, where the vehicle is.
void add_vehicle(Scene& scene, const ScanPicture& picture) {
  const float ground = -static_cast<float>(picture.sensor_height_m);
  scene.corners = {{.x = 1.6F, .z = ground, .color = kInk},
                   {.x = -1.6F, .y = 1.0F, .z = ground, .color = kInk},
                   {.x = -0.9F, .z = ground, .color = kInk},
                   {.x = -1.6F, .y = -1.0F, .z = ground, .color = kInk}};
  scene.triangles = {0, 1, 2, 0, 2, 3};
}

void label_rings(Figure& figure, const Camera& camera, const ScanPicture& picture) {
  const Font font{.size_px = 0.85 * figure.font_px(), .color = kFaintInk};
  for (int ring = 1; ring <= kRings; ++ring) {
    const double radius = ring * ring_step(picture);
    const PixelPoint place =
        place_on(figure.plot(), camera, {radius, 0.0, -picture.sensor_height_m});
    const std::string words = fmt::format("{:g} m", radius);
    const double width = figure.canvas().text_width(words, font);
    const Rectangle plate{place.x - 0.5 * width - 2.0, place.y - 0.6 * font.size_px, width + 4.0,
                          1.2 * font.size_px};
    if (plate.y < figure.plot().y || plate.bottom() > figure.plot().bottom()) continue;
    figure.canvas().fill(plate, kWhite, 0.75);
    figure.canvas().text(words, {place.x, place.y + 0.36 * font.size_px}, Anchor::middle, font);
  }
}

}  // namespace

Image draw_scan_in_perspective(const PerspectiveRenderer& renderer, const ScanPicture& picture,
                               const ViewPoint& view, ImageSize size) {
  require_matching(picture);
  Figure figure(size,
                {.title = picture.title, .caption = picture.caption, .legend = legend_of(picture)});
  Scene scene{.least_point_px = std::max(1.2, 0.0018 * figure.plot().height)};
  add_rings(scene, picture);
  add_points(scene, picture);
  add_vehicle(scene, picture);
  ViewPoint from = view;
  if (from.distance_m <= 0.0) from.distance_m = 0.8 * picture.range_m;
  const Camera camera = camera_at(from, {0.1 * picture.range_m, 0.0, -picture.sensor_height_m},
                                  Eigen::Vector3d::UnitX());
  const ImageSize inner{static_cast<int>(figure.plot().width),
                        static_cast<int>(figure.plot().height)};
  figure.canvas().paste(renderer.draw(scene, camera, inner), figure.plot());
  label_rings(figure, camera, picture);
  return figure.finish();
}

}  // namespace groundgrid::rendering
