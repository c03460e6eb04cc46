#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid simulate`: a drive with exact labels and terrain, in SemanticKITTI layout.
void add_simulate(CLI::App& app);

}  // namespace groundgrid::program
