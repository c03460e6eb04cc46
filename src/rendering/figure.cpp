#include "rendering/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "rendering/nice_numbers.hpp"
#include "rendering/text.hpp"

namespace groundgrid::rendering {
namespace {

constexpr double kTitleSize = 1.25;  // All in units of the font.
constexpr double kCaptionSize = 0.92;
constexpr double kLineHeight = 1.5;
constexpr double kMarkWidth = 1.1;
constexpr double kMarkGap = 0.45;
constexpr double kEntryGap = 1.6;
constexpr double kBarWidth = 1.1;
constexpr double kTickGap = 0.4;

constexpr Color kNoDataGround{232, 232, 232};
constexpr Color kNoDataHatch{205, 205, 205};

}  // namespace

double font_size(ImageSize size) {
  constexpr double kLeast = 9.0;
  return std::max(kLeast, 0.0155 * std::sqrt(static_cast<double>(size.pixels())));
}

void fill_no_data(Canvas& canvas, const Rectangle& area, double font_px) {
  canvas.fill(area, kNoDataGround);
  canvas.clip(area);
  const double step = 0.5 * font_px;
  const int hatches = static_cast<int>(std::ceil((area.width + area.height) / step));
  for (int i = 0; i < hatches; ++i) {
    const double x = area.x - area.height + i * step;
    const std::array hatch{PixelPoint{x, area.bottom()}, PixelPoint{x + area.height, area.y}};
    canvas.line(hatch, {.color = kNoDataHatch, .width_px = 0.08 * font_px});
  }
  canvas.unclip();
}

Figure::Figure(ImageSize size, FigureText text)
    : text_(std::move(text)),
      canvas_(size),
      font_px_(font_size(size)),
      margin_(std::round(0.8 * font_px_)),
      legend_(legend_rows()) {
  const double heading = (text_.title.empty() ? 0.0 : kTitleSize * kLineHeight) +
                         (text_.caption.empty() ? 0.0 : kCaptionSize * kLineHeight);
  const double top = std::round(margin_ + heading * font_px_);
  const double legend = static_cast<double>(legend_.size()) * kLineHeight * font_px_;
  const double below = legend_.empty() ? margin_ : std::round(1.4 * margin_ + legend);
  const double right = text_.bar ? std::round(2.0 * margin_ + bar_width()) : margin_;
  plot_ = {margin_, top, std::max(1.0, size.width - margin_ - right),
           std::max(1.0, size.height - top - below)};
  draw_heading();
  draw_legend();
  if (text_.bar) draw_bar();
}

double Figure::entry_width(const LegendEntry& entry) {
  return (kMarkWidth + kMarkGap) * font_px_ + canvas_.text_width(entry.text, {.size_px = font_px_});
}

std::vector<Figure::LegendRow> Figure::legend_rows() {
  std::vector<LegendRow> rows;
  const double room = canvas_.size().width - 2.0 * margin_;
  double left = room;
  for (const LegendEntry& entry : text_.legend) {
    const double width = entry_width(entry);
    if (rows.empty() || width > left) {
      rows.emplace_back();
      left = room;
    }
    rows.back().entries.push_back(entry);
    left -= width + kEntryGap * font_px_;
  }
  return rows;
}

void Figure::draw_fitting(const std::string& text, PixelPoint place, Font font) {
  const double room = canvas_.size().width - place.x - margin_;
  std::string shown = drawable(text);
  for (std::string kept = shown; canvas_.text_width(shown, font) > room && !kept.empty();) {
    kept = without_last_character(std::move(kept));
    shown = kept + "\u2026";
  }
  canvas_.text(shown, place, Anchor::left, font);
}

void Figure::draw_heading() {
  double y = margin_;
  if (!text_.title.empty()) {
    y += kTitleSize * font_px_;
    draw_fitting(text_.title, {margin_, y - 0.15 * font_px_},
                 {.size_px = kTitleSize * font_px_, .bold = true});
    y += kTitleSize * (kLineHeight - 1.0) * font_px_;
  }
  if (!text_.caption.empty())
    draw_fitting(text_.caption, {margin_, y + (kCaptionSize - 0.15) * font_px_},
                 {.size_px = kCaptionSize * font_px_, .color = kFaintInk});
}

void Figure::draw_legend() {
  double baseline = plot_.bottom() + 0.5 * margin_ + font_px_;
  for (const LegendRow& row : legend_) {
    double x = margin_;
    for (const LegendEntry& entry : row.entries) {
      draw_mark(entry, {x, baseline - 0.36 * font_px_});
      draw_fitting(entry.text, {x + (kMarkWidth + kMarkGap) * font_px_, baseline},
                   {.size_px = font_px_});
      x += entry_width(entry) + kEntryGap * font_px_;
    }
    baseline += kLineHeight * font_px_;
  }
}

void Figure::draw_mark(const LegendEntry& entry, PixelPoint left) {
  const double width = kMarkWidth * font_px_;
  const Rectangle box{left.x, left.y - 0.4 * font_px_, width, 0.8 * font_px_};
  const std::array stretch{left, PixelPoint{left.x + width, left.y}};
  switch (entry.mark) {
    case LegendMark::disc:
      return canvas_.disc({left.x + width / 2.0, left.y}, 0.38 * font_px_, entry.color);
    case LegendMark::line:
      canvas_.line(stretch, {.color = kInk, .width_px = 0.4 * font_px_});
      return canvas_.line(stretch, {.color = entry.color, .width_px = 0.2 * font_px_});
    case LegendMark::box:
      return canvas_.fill(box, entry.color);
    case LegendMark::no_data:
      fill_no_data(canvas_, box, 0.7 * font_px_);
      return canvas_.outline(box, {.width_px = 0.06 * font_px_});
  }
}

std::vector<double> Figure::bar_ticks(double height) const {
  const int most = std::clamp(static_cast<int>(height / (2.2 * font_px_)), 2, 9);
  return ticks_between(text_.bar->low, text_.bar->high, most);
}

double Figure::bar_width() {
  double widest = 0.0;
  const std::vector<double> ticks = bar_ticks(0.7 * canvas_.size().height);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  for (const double tick : ticks)
    widest = std::max(widest, canvas_.text_width(tick_text(tick, step), {.size_px = font_px_}));
  const double label = text_.bar->label.empty() ? 0.0 : 1.6;
  return (kBarWidth + kTickGap + label) * font_px_ + widest;
}

void Figure::draw_bar() {
  const ColorBar& bar = *text_.bar;
  const Rectangle area{plot_.right() + margin_, plot_.y, std::round(kBarWidth * font_px_),
                       plot_.height};
  const int rows = static_cast<int>(area.height);
  for (int row = 0; row < rows; ++row)
    canvas_.fill({area.x, area.y + row, area.width, 1.0}, bar.colors->at(1.0 - (row + 0.5) / rows));
  canvas_.outline(area, {.width_px = std::max(1.0, 0.06 * font_px_)});
  const std::vector<double> ticks = bar_ticks(area.height);
  const double step = ticks.size() > 1 ? ticks[1] - ticks[0] : 1.0;
  const double left = area.right() + kTickGap * font_px_;
  for (const double tick : ticks) {
    const double y = area.bottom() - area.height * (tick - bar.low) / (bar.high - bar.low);
    const std::array mark{PixelPoint{area.right(), y},
                          PixelPoint{area.right() + 0.2 * font_px_, y}};
    canvas_.line(mark, {.width_px = std::max(1.0, 0.06 * font_px_)});
    const double baseline =
        std::clamp(y + 0.36 * font_px_, area.y + 0.72 * font_px_, area.bottom());
    canvas_.text(tick_text(tick, step), {left, baseline}, Anchor::left, {.size_px = font_px_});
  }
  if (!bar.label.empty())
    canvas_.upright_text(bar.label,
                         {canvas_.size().width - margin_ - 0.3 * font_px_, area.middle().y},
                         {.size_px = font_px_});
}

Image Figure::finish() {
  canvas_.outline(plot_, {.width_px = std::max(1.0, 0.06 * font_px_)});
  return canvas_.image();
}

}  // namespace groundgrid::rendering
