#pragma once

#include <CLI/App.hpp>

#include "program/arguments.hpp"

namespace groundgrid::program {

/// Adds `groundgrid evaluate-terrain`: scores a height raster against a reference (paper IV-C).
void add_evaluate_terrain(CLI::App& app, const Arguments& arguments);

}  // namespace groundgrid::program
