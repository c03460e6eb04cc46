#include "rendering/scan_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "rendering/nice_numbers.hpp"
#include "rendering/scale_bar.hpp"

namespace groundgrid::rendering {
namespace {

constexpr Color kRing{214, 214, 214};

/// Where metres go on the plot.
class TopView {
 public:
  TopView(const Rectangle& plot, double range_m)
      : plot_(plot), pixels_per_m_(std::min(plot.width, plot.height) / (2.0 * range_m)) {}

  [[nodiscard]] double pixels_per_m() const { return pixels_per_m_; }
  [[nodiscard]] double corner_m() const {
    return std::hypot(plot_.width, plot_.height) / (2.0 * pixels_per_m_);
  }
  [[nodiscard]] PixelPoint place(double x_m, double y_m) const {
    const PixelPoint middle = plot_.middle();
    return {middle.x - y_m * pixels_per_m_, middle.y - x_m * pixels_per_m_};
  }
  [[nodiscard]] bool shows(PixelPoint place) const {
    return place.x >= plot_.x && place.x < plot_.right() && place.y >= plot_.y &&
           place.y < plot_.bottom();
  }

 private:
  Rectangle plot_;
  double pixels_per_m_;
};

void draw_rings(Figure& figure, const TopView& view, double range_m) {
  const double step = nice_below(range_m / 2.0);
  const int rings = static_cast<int>(view.corner_m() / step);
  for (int i = 1; i <= rings; ++i)
    figure.canvas().circle(view.place(0.0, 0.0), i * step * view.pixels_per_m(),
                           {.color = kRing, .width_px = std::max(0.8, 0.06 * figure.font_px())});
}

void draw_points(Figure& figure, const TopView& view, const ScanPicture& picture) {
  const double radius =
      std::max(0.55, 0.0011 * std::min(figure.plot().width, figure.plot().height));
  for (std::size_t style = 0; style < picture.styles.size(); ++style)
    for (std::size_t i = 0; i < picture.group.size(); ++i) {
      if (picture.group[i] != style) continue;
      const PixelPoint place = view.place(static_cast<double>(picture.coordinates[3 * i]),
                                          static_cast<double>(picture.coordinates[3 * i + 1]));
      if (view.shows(place))
        figure.canvas().disc(place, radius * picture.styles[style].size,
                             picture.styles[style].color);
    }
}

// An arrow head that looks ahead, where the LiDAR is.
void draw_vehicle(Figure& figure, const TopView& view) {
  const PixelPoint middle = view.place(0.0, 0.0);
  const double length = 0.55 * figure.font_px();
  const std::array corners{PixelPoint{middle.x, middle.y - length},
                           PixelPoint{middle.x + 0.7 * length, middle.y + length},
                           PixelPoint{middle.x, middle.y + 0.55 * length},
                           PixelPoint{middle.x - 0.7 * length, middle.y + length}};
  figure.canvas().polygon(corners, kInk);
}

std::string percent(std::size_t part, std::size_t whole) {
  if (part == 0 || whole == 0) return "0 %";
  // Cut, not rounded: 100 % is all of them.
  const std::size_t tenths = 1000 * part / whole;
  return tenths == 0 ? "<0.1 %" : fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

}  // namespace

void require_matching(const ScanPicture& picture) {
  if (picture.coordinates.size() != 3 * picture.group.size())
    throw std::invalid_argument("a picture of a scan needs three coordinates and a group a point");
}

std::vector<LegendEntry> legend_of(const ScanPicture& picture) {
  std::vector<std::size_t> counts(picture.styles.size());
  for (const std::uint8_t group : picture.group)
    if (group < counts.size()) ++counts[group];
  std::vector<LegendEntry> legend;
  for (std::size_t i = 0; i < counts.size(); ++i)
    legend.push_back({.text = fmt::format("{} {}", picture.styles[i].name,
                                          percent(counts[i], picture.group.size())),
                      .color = picture.styles[i].color});
  return legend;
}

Image draw_scan_from_above(const ScanPicture& picture, ImageSize size) {
  require_matching(picture);
  Figure figure(size,
                {.title = picture.title, .caption = picture.caption, .legend = legend_of(picture)});
  const TopView view(figure.plot(), picture.range_m);
  figure.canvas().clip(figure.plot());
  draw_rings(figure, view, picture.range_m);
  draw_points(figure, view, picture);
  draw_vehicle(figure, view);
  figure.canvas().unclip();
  draw_scale_bar(figure.canvas(), figure.plot(), view.pixels_per_m(), figure.font_px());
  draw_up_arrow(figure.canvas(), figure.plot(), "ahead", figure.font_px());
  return figure.finish();
}

}  // namespace groundgrid::rendering
