#pragma once

#include <optional>
#include <string>
#include <vector>

#include "rendering/canvas.hpp"
#include "rendering/color_map.hpp"

namespace groundgrid::rendering {

/// What stands before a text of the legend. A line has dark edges.
enum class LegendMark : std::uint8_t { disc, line, box, no_data };

struct LegendEntry {
  std::string text{};
  Color color{};
  LegendMark mark = LegendMark::disc;
};

/// A scale of colours beside the plot.
struct ColorBar {
  const ColorMap* colors = nullptr;
  double low = 0.0;
  double high = 1.0;
  std::string label{};
};

/// All that a figure says around its plot.
struct FigureText {
  std::string title{};
  std::string caption{};
  std::vector<LegendEntry> legend{};
  std::optional<ColorBar> bar{};
};

/// A picture with a title and caption above its plot, a colour bar to the right and a legend below.
/// All sizes follow that of the picture; what is too long for it is cut, with an ellipsis.
class Figure {
 public:
  Figure(ImageSize size, FigureText text);

  /// Where the plot goes: whole pixels.
  [[nodiscard]] const Rectangle& plot() const { return plot_; }
  [[nodiscard]] Canvas& canvas() { return canvas_; }
  /// Of the text in the plot.
  [[nodiscard]] double font_px() const { return font_px_; }

  /// Draws the frame around what the plot holds by now. To be called last.
  Image finish();

 private:
  struct LegendRow {
    std::vector<LegendEntry> entries{};
  };

  [[nodiscard]] double entry_width(const LegendEntry& entry);
  [[nodiscard]] std::vector<LegendRow> legend_rows();
  [[nodiscard]] std::vector<double> bar_ticks(double height) const;
  [[nodiscard]] double bar_width();
  void draw_heading();
  void draw_legend();
  void draw_mark(const LegendEntry& entry, PixelPoint left);
  void draw_bar();
  void draw_fitting(const std::string& text, PixelPoint place, Font font);

  FigureText text_;
  Canvas canvas_;
  double font_px_;
  double margin_;
  std::vector<LegendRow> legend_{};
  Rectangle plot_{};
};

/// The size of letters in a picture of that size.
double font_size(ImageSize size);

/// The ground of a plot on which nothing is known: hatched, like no colour of a map.
void fill_no_data(Canvas& canvas, const Rectangle& area, double font_px);

}  // namespace groundgrid::rendering
