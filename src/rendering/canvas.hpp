#pragma once

#include <memory>
#include <span>
#include <string>

#include "rendering/color.hpp"
#include "rendering/image.hpp"

namespace groundgrid::rendering {

/// In pixels from the upper left corner of the image; x to the right, y down.
struct PixelPoint {
  double x = 0.0;
  double y = 0.0;
};

struct Rectangle {
  double x = 0.0;  ///< Left edge.
  double y = 0.0;  ///< Upper edge.
  double width = 0.0;
  double height = 0.0;

  [[nodiscard]] double right() const { return x + width; }
  [[nodiscard]] double bottom() const { return y + height; }
  [[nodiscard]] PixelPoint middle() const { return {x + width / 2.0, y + height / 2.0}; }
};

struct Font {
  double size_px = 12.0;
  bool bold = false;
  Color color = kInk;
};

/// Where a text stands from its place.
enum class Anchor : std::uint8_t { left, middle, right };

/// How lines end and meet.
struct Stroke {
  Color color = kInk;
  double width_px = 1.0;
};

/// An image to draw on, white at first. Sizes and places are pixels.
class Canvas {
 public:
  /// Throws std::bad_alloc where memory does not hold the image.
  explicit Canvas(ImageSize size);
  ~Canvas();
  Canvas(const Canvas&) = delete;
  Canvas& operator=(const Canvas&) = delete;
  Canvas(Canvas&&) noexcept;
  Canvas& operator=(Canvas&&) noexcept;

  [[nodiscard]] ImageSize size() const { return size_; }

  /// From here on only what lies inside is drawn; unclip() ends it.
  void clip(const Rectangle& area);
  void unclip();

  void fill(const Rectangle& area, Color color, double opacity = 1.0);
  void outline(const Rectangle& area, const Stroke& stroke);
  void line(std::span<const PixelPoint> points, const Stroke& stroke);
  void polygon(std::span<const PixelPoint> points, Color color);
  void disc(PixelPoint middle, double radius, Color color);
  void circle(PixelPoint middle, double radius, const Stroke& stroke);

  /// `place` is on the baseline. What is no UTF-8 or a control character is drawn as '?'.
  void text(const std::string& text, PixelPoint place, Anchor anchor, const Font& font);
  /// The same, turned to be read from below.
  void upright_text(const std::string& text, PixelPoint middle, const Font& font);
  [[nodiscard]] double text_width(const std::string& text, const Font& font);

  /// Draws an image into an area. Where it grows its pixels stay squares.
  void paste(const Image& image, const Rectangle& area);

  /// What is drawn so far. Throws std::runtime_error where drawing has failed.
  [[nodiscard]] Image image();

 private:
  class Cairo;
  void choose(const Font& font);

  ImageSize size_;
  std::unique_ptr<Cairo> cairo_;
};

}  // namespace groundgrid::rendering
