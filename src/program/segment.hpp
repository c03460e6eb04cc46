#pragma once

#include <CLI/App.hpp>

#include "program/arguments.hpp"

namespace groundgrid::program {

/// Adds `groundgrid segment`: a label for every point of every scan, written to a folder.
///
/// A sequence whose poses cannot be used, or are too few, stops the run before its first scan. A
/// scan that cannot be read or holds no points stops it there; what is finished stays, and there is
/// no run.json. With --keep-going such sequences and scans, and scans without a pose, are skipped,
/// named on standard error and listed in run.json, whose `complete` is then false; the run succeeds
/// if any scan did. Failing to write always stops the run.
void add_segment(CLI::App& app, const Arguments& arguments);

}  // namespace groundgrid::program
