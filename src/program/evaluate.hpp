#pragma once

#include <CLI/App.hpp>

#include "program/arguments.hpp"

namespace groundgrid::program {

/// Adds `groundgrid evaluate`: the figures of the method, or of any predictions, on labelled scans.
void add_evaluate(CLI::App& app, const Arguments& arguments);

}  // namespace groundgrid::program
