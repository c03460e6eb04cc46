#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid render error`: what a terrain's heights are off by, from above.
void add_render_error(CLI::App& render);

}  // namespace groundgrid::program
