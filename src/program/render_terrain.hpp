#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid render terrain`: a raster of heights, hillshaded.
void add_render_terrain(CLI::App& render);

}  // namespace groundgrid::program
