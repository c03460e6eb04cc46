#include "rendering/canvas.hpp"

#include <cairo.h>

#include <cstring>
#include <new>
#include <numbers>
#include <stdexcept>

#include "rendering/text.hpp"

namespace groundgrid::rendering {
namespace {

struct DestroySurface {
  void operator()(cairo_surface_t* surface) const { cairo_surface_destroy(surface); }
};
using SurfacePtr = std::unique_ptr<cairo_surface_t, DestroySurface>;

struct DestroyContext {
  void operator()(cairo_t* context) const { cairo_destroy(context); }
};
using ContextPtr = std::unique_ptr<cairo_t, DestroyContext>;

[[noreturn]] void fail(cairo_status_t status) {
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  throw std::runtime_error(std::string("drawing failed: ") + cairo_status_to_string(status));
}

SurfacePtr make_surface(cairo_format_t format, ImageSize size) {
  SurfacePtr surface(cairo_image_surface_create(format, size.width, size.height));
  if (const auto status = cairo_surface_status(surface.get()); status != CAIRO_STATUS_SUCCESS)
    fail(status);
  return surface;
}

std::size_t row_bytes(ImageSize size) {
  return static_cast<std::size_t>(size.width) * sizeof(std::uint32_t);
}

SurfacePtr surface_of(const Image& image) {
  SurfacePtr surface = make_surface(CAIRO_FORMAT_ARGB32, image.size);
  unsigned char* row = cairo_image_surface_get_data(surface.get());
  const int stride = cairo_image_surface_get_stride(surface.get());
  for (int y = 0; y < image.size.height; ++y, row += stride)
    std::memcpy(
        row,
        &image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(image.size.width)],
        row_bytes(image.size));
  cairo_surface_mark_dirty(surface.get());
  return surface;
}

void set_color(cairo_t* context, Color color, double opacity = 1.0) {
  cairo_set_source_rgba(context, color.red / 255.0, color.green / 255.0, color.blue / 255.0,
                        opacity);
}

void trace(cairo_t* context, const Rectangle& area) {
  cairo_rectangle(context, area.x, area.y, area.width, area.height);
}

void trace(cairo_t* context, std::span<const PixelPoint> points) {
  for (const PixelPoint& point : points) cairo_line_to(context, point.x, point.y);
}

void trace_circle(cairo_t* context, PixelPoint middle, double radius) {
  cairo_new_sub_path(context);
  cairo_arc(context, middle.x, middle.y, radius, 0.0, 2.0 * std::numbers::pi);
}

void stroke_path(cairo_t* context, const Stroke& stroke) {
  set_color(context, stroke.color);
  cairo_set_line_width(context, stroke.width_px);
  cairo_stroke(context);
}

}  // namespace

class Canvas::Cairo {
 public:
  explicit Cairo(ImageSize size)
      : surface_(make_surface(CAIRO_FORMAT_RGB24, size)), context_(cairo_create(surface_.get())) {
    cairo_set_line_join(get(), CAIRO_LINE_JOIN_ROUND);
    cairo_set_line_cap(get(), CAIRO_LINE_CAP_BUTT);
    set_color(get(), kWhite);
    cairo_paint(get());
  }

  [[nodiscard]] cairo_t* get() const { return context_.get(); }
  [[nodiscard]] cairo_surface_t* surface() const { return surface_.get(); }

 private:
  SurfacePtr surface_;
  ContextPtr context_;
};

Canvas::Canvas(ImageSize size) : size_(size), cairo_(std::make_unique<Cairo>(size)) {
  // The same pixels whatever the desktop's settings: grey edges, no hints.
  cairo_font_options_t* const options = cairo_font_options_create();
  cairo_font_options_set_antialias(options, CAIRO_ANTIALIAS_GRAY);
  cairo_font_options_set_hint_style(options, CAIRO_HINT_STYLE_NONE);
  cairo_font_options_set_hint_metrics(options, CAIRO_HINT_METRICS_OFF);
  cairo_set_font_options(cairo_->get(), options);
  cairo_font_options_destroy(options);
}

Canvas::~Canvas() = default;
Canvas::Canvas(Canvas&&) noexcept = default;
Canvas& Canvas::operator=(Canvas&&) noexcept = default;

void Canvas::clip(const Rectangle& area) {
  cairo_save(cairo_->get());
  trace(cairo_->get(), area);
  cairo_clip(cairo_->get());
}

void Canvas::unclip() { cairo_restore(cairo_->get()); }

void Canvas::fill(const Rectangle& area, Color color, double opacity) {
  set_color(cairo_->get(), color, opacity);
  trace(cairo_->get(), area);
  cairo_fill(cairo_->get());
}

void Canvas::outline(const Rectangle& area, const Stroke& stroke) {
  trace(cairo_->get(), area);
  stroke_path(cairo_->get(), stroke);
}

void Canvas::line(std::span<const PixelPoint> points, const Stroke& stroke) {
  trace(cairo_->get(), points);
  stroke_path(cairo_->get(), stroke);
}

void Canvas::polygon(std::span<const PixelPoint> points, Color color) {
  set_color(cairo_->get(), color);
  trace(cairo_->get(), points);
  cairo_fill(cairo_->get());
}

void Canvas::disc(PixelPoint middle, double radius, Color color) {
  set_color(cairo_->get(), color);
  trace_circle(cairo_->get(), middle, radius);
  cairo_fill(cairo_->get());
}

void Canvas::circle(PixelPoint middle, double radius, const Stroke& stroke) {
  trace_circle(cairo_->get(), middle, radius);
  stroke_path(cairo_->get(), stroke);
}

void Canvas::choose(const Font& font) {
  cairo_select_font_face(cairo_->get(), "DejaVu Sans", CAIRO_FONT_SLANT_NORMAL,
                         font.bold ? CAIRO_FONT_WEIGHT_BOLD : CAIRO_FONT_WEIGHT_NORMAL);
  cairo_set_font_size(cairo_->get(), font.size_px);
}

double Canvas::text_width(const std::string& text, const Font& font) {
  choose(font);
  cairo_text_extents_t extents{};
  cairo_text_extents(cairo_->get(), drawable(text).c_str(), &extents);
  return extents.x_advance;
}

void Canvas::text(const std::string& text, PixelPoint place, Anchor anchor, const Font& font) {
  const double width = text_width(text, font);
  if (anchor == Anchor::middle) place.x -= width / 2.0;
  if (anchor == Anchor::right) place.x -= width;
  set_color(cairo_->get(), font.color);
  cairo_move_to(cairo_->get(), place.x, place.y);
  cairo_show_text(cairo_->get(), drawable(text).c_str());
  cairo_new_path(cairo_->get());
}

void Canvas::upright_text(const std::string& text, PixelPoint middle, const Font& font) {
  cairo_save(cairo_->get());
  cairo_translate(cairo_->get(), middle.x, middle.y);
  cairo_rotate(cairo_->get(), -std::numbers::pi / 2.0);
  this->text(text, {0.0, 0.35 * font.size_px}, Anchor::middle, font);
  cairo_restore(cairo_->get());
}

void Canvas::paste(const Image& image, const Rectangle& area) {
  const SurfacePtr surface = surface_of(image);
  cairo_t* const context = cairo_->get();
  cairo_save(context);
  trace(context, area);
  cairo_clip(context);
  cairo_translate(context, area.x, area.y);
  const double scale_x = area.width / image.size.width;
  const double scale_y = area.height / image.size.height;
  cairo_scale(context, scale_x, scale_y);
  cairo_set_source_surface(context, surface.get(), 0.0, 0.0);
  const bool grows = scale_x >= 1.0 && scale_y >= 1.0;
  cairo_pattern_set_filter(cairo_get_source(context),
                           grows ? CAIRO_FILTER_NEAREST : CAIRO_FILTER_GOOD);
  cairo_paint(context);
  cairo_restore(context);
}

Image Canvas::image() {
  if (const auto status = cairo_status(cairo_->get()); status != CAIRO_STATUS_SUCCESS) fail(status);
  cairo_surface_flush(cairo_->surface());
  Image image{.size = size_, .pixels = std::vector<std::uint32_t>(size_.pixels())};
  const unsigned char* row = cairo_image_surface_get_data(cairo_->surface());
  const int stride = cairo_image_surface_get_stride(cairo_->surface());
  for (int y = 0; y < size_.height; ++y, row += stride)
    std::memcpy(&image.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width)],
                row, row_bytes(size_));
  for (std::uint32_t& pixel : image.pixels) pixel |= 0xFF000000U;
  return image;
}

}  // namespace groundgrid::rendering
