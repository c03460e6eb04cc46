#pragma once

#include "rendering/canvas.hpp"

namespace groundgrid::rendering {

/// The round length, in metres, that a bar on a plot of that width shows: at most a quarter of it.
double scale_bar_length(double plot_width_px, double pixels_per_m);

/// Draws a scale bar in the lower left corner of a plot. Its bar is exactly its length.
void draw_scale_bar(Canvas& canvas, const Rectangle& plot, double pixels_per_m, double font_px);

/// Draws an arrow upwards in the upper right corner, with what lies there in a word.
void draw_up_arrow(Canvas& canvas, const Rectangle& plot, const std::string& word, double font_px);

}  // namespace groundgrid::rendering
