#include "rendering/scale_bar.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "rendering/nice_numbers.hpp"

namespace groundgrid::rendering {
namespace {

constexpr double kPlateOpacity = 0.85;

}  // namespace

double scale_bar_length(double plot_width_px, double pixels_per_m) {
  return nice_below(0.25 * plot_width_px / pixels_per_m);
}

void draw_scale_bar(Canvas& canvas, const Rectangle& plot, double pixels_per_m, double font_px) {
  const double length_m = scale_bar_length(plot.width, pixels_per_m);
  const double length_px = length_m * pixels_per_m;
  const std::string words = fmt::format("{:g} m", length_m);
  const Font font{.size_px = font_px};
  const double width = std::max(length_px, canvas.text_width(words, font));
  const double gap = 0.5 * font_px;
  const Rectangle plate{plot.x + gap, plot.bottom() - 3.0 * gap - 1.3 * font_px, width + 2.0 * gap,
                        2.0 * gap + 1.3 * font_px};
  canvas.fill(plate, kWhite, kPlateOpacity);
  const double thickness = std::max(2.0, std::round(0.25 * font_px));
  const double left = std::round(plate.middle().x - length_px / 2.0);
  const double top = std::round(plate.bottom() - gap - thickness);
  canvas.fill({left, top, length_px, thickness}, kInk);
  canvas.text(words, {plate.middle().x, top - 0.35 * font_px}, Anchor::middle, font);
}

void draw_up_arrow(Canvas& canvas, const Rectangle& plot, const std::string& word, double font_px) {
  const Font font{.size_px = font_px};
  const double gap = 0.5 * font_px;
  const double width = std::max(canvas.text_width(word, font), font_px) + 2.0 * gap;
  const double height = 3.6 * font_px;
  const Rectangle plate{plot.right() - gap - width, plot.y + gap, width, height};
  canvas.fill(plate, kWhite, kPlateOpacity);
  const double x = plate.middle().x;
  const double tip = plate.y + gap;
  const double foot = tip + 1.7 * font_px;
  const std::array shaft{PixelPoint{x, tip + 0.5 * font_px}, PixelPoint{x, foot}};
  canvas.line(shaft, {.width_px = std::max(1.5, 0.13 * font_px)});
  const std::array head{PixelPoint{x, tip}, PixelPoint{x - 0.35 * font_px, tip + 0.8 * font_px},
                        PixelPoint{x + 0.35 * font_px, tip + 0.8 * font_px}};
  canvas.polygon(head, kInk);
  canvas.text(word, {x, plate.bottom() - gap}, Anchor::middle, font);
}

}  // namespace groundgrid::rendering
