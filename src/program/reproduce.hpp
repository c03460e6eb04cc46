#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid reproduce`: the paper's Table I, its published figures beside those of both
/// presets on the sequences that are there, with one thread and with all of them.
///
/// Other labels with more threads are a failure, as a missing label file or pose is: figures over a
/// part would look like figures over all.
void add_reproduce(CLI::App& app);

}  // namespace groundgrid::program
