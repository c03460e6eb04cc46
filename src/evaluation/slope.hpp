#pragma once

#include <span>
#include <vector>

#include "evaluation/cell_lattice.hpp"

namespace groundgrid::evaluation {

/// Slope of a surface in percent (100 is 45°): the steepest rise over the cells on both sides, or
/// over one side where the other has no height. NaN where a cell, or both its neighbours along x
/// or along y, have none.
std::vector<float> slope_percent(std::span<const float> heights_m, const CellLattice& lattice);

}  // namespace groundgrid::evaluation
