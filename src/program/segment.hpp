#pragma once

#include <CLI/App.hpp>

namespace groundgrid::program {

/// Adds `groundgrid segment`: a label for every point of every scan, written to a folder.
///
/// A scan that cannot be read, holds no points or has no pose stops the run; what is finished
/// stays, and there is no run.json. With --keep-going it is skipped, named on standard error and
/// listed in run.json, whose `complete` is then false; the run succeeds if any scan did. Failing
/// to write always stops the run.
void add_segment(CLI::App& app);

}  // namespace groundgrid::program
