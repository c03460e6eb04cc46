#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/paper_method.hpp"
#include "core/plane_hierarchy.hpp"
#include "core/rasterization.hpp"

/// The default method as plain code: scalar, one thread, values in and values out. It is what
/// Config::method = Method::reference runs; the fast stages give the same bits, which
/// tests/property/reference_test.cpp shows. Read it from the bottom: process() is the whole.
namespace groundgrid::reference {

using paper::Answers;
using paper::Scan;

/// One element for each cell of the window, row by row.
template <typename T>
using PerCell = std::vector<T>;

/// A scan whose points have their cells and heights in `bins`. `ground` is the plane that the
/// vehicle stands on, `grid` a buffer that tells afterwards what was seen.
LabelCounts process(const Scan& scan, const LocalPlane& ground, const Config& config,
                    BinnedPoints& bins, ScanGrid& grid, ElevationMap& map, const Answers& answers);

}  // namespace groundgrid::reference
