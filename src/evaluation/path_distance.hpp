#pragma once

#include <span>
#include <vector>

#include "evaluation/cell_lattice.hpp"

namespace groundgrid::evaluation {

/// A place on a lattice, counted in cells from its corner: (0.5, 0.5) is the middle of cell (0, 0).
struct LatticePoint {
  double column;
  double row;
};

/// From the middle of each cell to that of the nearest cell that the path crosses, metres: right to
/// a cell's width. The path runs straight from point to point; what lies outside the lattice does
/// not count. Empty where no point of it lies inside.
std::vector<float> path_distance(std::span<const LatticePoint> path, const CellLattice& lattice);

}  // namespace groundgrid::evaluation
