#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "evaluation/cell_lattice.hpp"

namespace groundgrid::evaluation {

/// From the middle of each cell to that of the nearest target, metres; infinite where there is no
/// target at all. A target is a cell that is not 0. Exact, in time that grows with the number of
/// cells alone. Throws std::invalid_argument where there is not one target a cell.
std::vector<float> distance_to(std::span<const std::uint8_t> targets, const CellLattice& lattice);

}  // namespace groundgrid::evaluation
