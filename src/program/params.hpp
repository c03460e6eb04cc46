#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid params`: every parameter of the method, as a table, a file for --config, JSON
/// or the page docs/parameters.md.
void add_params(CLI::App& app);

}  // namespace groundgrid::program
