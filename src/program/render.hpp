#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid render`: pictures of scans, terrains, their errors and drives.
void add_render(CLI::App& app);

}  // namespace groundgrid::program
