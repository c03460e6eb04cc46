#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid render drive`: the scans of a sequence one after another, as a GIF.
void add_render_drive(CLI::App& render);

}  // namespace groundgrid::program
