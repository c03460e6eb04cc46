#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid render scan`: the points of a scan by their labels or by what is wrong with
/// these, from above.
void add_render_scan(CLI::App& render);

}  // namespace groundgrid::program
