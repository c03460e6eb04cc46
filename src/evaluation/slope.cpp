#include "evaluation/slope.hpp"

#include <cmath>
#include <limits>

namespace groundgrid::evaluation {
namespace {

constexpr double kNoSlope = std::numeric_limits<double>::quiet_NaN();

/// The rise per metre at the middle of three heights; NaN where the outer ones do not tell it.
double rise(double before, double here, double after, double step_m) {
  if (std::isnan(before)) return (after - here) / step_m;
  if (std::isnan(after)) return (here - before) / step_m;
  return (after - before) / (2.0 * step_m);
}

}  // namespace

std::vector<float> slope_percent(std::span<const float> heights_m, const CellLattice& lattice) {
  const auto height = [&](int column, int row) {
    const bool inside = column >= 0 && column < lattice.columns && row >= 0 && row < lattice.rows;
    return inside ? static_cast<double>(heights_m[lattice.index(column, row)]) : kNoSlope;
  };
  std::vector<float> slope(lattice.cells());
  for (int row = 0; row < lattice.rows; ++row) {
    for (int column = 0; column < lattice.columns; ++column) {
      const double here = height(column, row);
      const double along_row =
          rise(height(column - 1, row), here, height(column + 1, row), lattice.cell_width_m);
      const double across_rows =
          rise(height(column, row - 1), here, height(column, row + 1), lattice.cell_height_m);
      const double steepest = std::isnan(here) ? kNoSlope : std::hypot(along_row, across_rows);
      slope[lattice.index(column, row)] = static_cast<float>(100.0 * steepest);
    }
  }
  return slope;
}

}  // namespace groundgrid::evaluation
