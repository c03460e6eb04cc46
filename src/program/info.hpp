#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid info`: what is in a file, folder or dataset, and what is wrong with it. Fails
/// where no scan can be read.
void add_info(CLI::App& app);

}  // namespace groundgrid::program
