#include "evaluation/path_distance.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "evaluation/cell_distance.hpp"

namespace groundgrid::evaluation {
namespace {

// So many steps a cell let the path skip but corners of cells.
constexpr double kStepsPerCell = 4.0;

class CrossedCells {
 public:
  explicit CrossedCells(const CellLattice& lattice)
      : lattice_(lattice), crossed_(lattice.cells()) {}

  void mark(const LatticePoint& point) {
    const double column = std::floor(point.column);
    const double row = std::floor(point.row);
    if (!(column >= 0.0 && column < lattice_.columns && row >= 0.0 && row < lattice_.rows)) return;
    crossed_[lattice_.index(static_cast<int>(column), static_cast<int>(row))] = 1;
    any_ = true;
  }

  void mark_line(const LatticePoint& from, const LatticePoint& to) {
    const double columns = to.column - from.column;
    const double rows = to.row - from.row;
    // A longer line leaves the lattice; its pieces inside may then have gaps.
    const double longest = static_cast<double>(lattice_.columns) + lattice_.rows;
    const double cells = std::min(std::max(std::abs(columns), std::abs(rows)), longest);
    if (std::isnan(cells)) return;
    const auto steps = static_cast<std::int64_t>(std::ceil(cells * kStepsPerCell));
    for (std::int64_t step = 1; step < steps; ++step) {
      const double part = static_cast<double>(step) / static_cast<double>(steps);
      mark({from.column + part * columns, from.row + part * rows});
    }
  }

  [[nodiscard]] bool any() const { return any_; }
  [[nodiscard]] const std::vector<std::uint8_t>& crossed() const { return crossed_; }

 private:
  CellLattice lattice_;
  std::vector<std::uint8_t> crossed_;
  bool any_ = false;
};

}  // namespace

std::vector<float> path_distance(std::span<const LatticePoint> path, const CellLattice& lattice) {
  CrossedCells cells(lattice);
  for (std::size_t i = 0; i < path.size(); ++i) {
    cells.mark(path[i]);
    if (i > 0) cells.mark_line(path[i - 1], path[i]);
  }
  if (!cells.any()) return {};
  return distance_to(cells.crossed(), lattice);
}

}  // namespace groundgrid::evaluation
