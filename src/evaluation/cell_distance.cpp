// The distance transform of Felzenszwalb and Huttenlocher (Theory of Computing 8, 2012): first the
// distance within each column, then the lower envelope of the parabolas that stand on each row.
#include "evaluation/cell_distance.hpp"

#include <cmath>
#include <limits>
#include <stdexcept>

namespace groundgrid::evaluation {
namespace {

constexpr float kNowhere = std::numeric_limits<float>::infinity();

std::vector<float> distance_within_columns(std::span<const std::uint8_t> targets,
                                           const CellLattice& lattice) {
  const auto step = static_cast<float>(lattice.cell_height_m);
  std::vector<float> distance(lattice.cells(), kNowhere);
  const auto take = [&](int column, int row, int from_row) {
    const std::size_t cell = lattice.index(column, row);
    if (targets[cell] != 0) distance[cell] = 0.0F;
    if (from_row < 0 || from_row >= lattice.rows) return;
    distance[cell] = std::min(distance[cell], distance[lattice.index(column, from_row)] + step);
  };
  for (int row = 0; row < lattice.rows; ++row)
    for (int column = 0; column < lattice.columns; ++column) take(column, row, row - 1);
  for (int row = lattice.rows - 1; row >= 0; --row)
    for (int column = 0; column < lattice.columns; ++column) take(column, row, row + 1);
  return distance;
}

/// The lower envelope of parabolas over one row, used again for every row.
class Envelope {
 public:
  explicit Envelope(double step_m) : step_m_(step_m) {}

  /// Turns the distances within columns into those over all cells.
  void apply(std::span<float> row) {
    parabolas_.clear();
    for (std::size_t column = 0; column < row.size(); ++column)
      if (row[column] < kNowhere)
        add({.at = static_cast<double>(column) * step_m_,
             .height = static_cast<double>(row[column]) * static_cast<double>(row[column])});
    if (parabolas_.empty()) return;
    std::size_t lowest = 0;
    for (std::size_t column = 0; column < row.size(); ++column) {
      const double at = static_cast<double>(column) * step_m_;
      while (lowest + 1 < parabolas_.size() && parabolas_[lowest + 1].from <= at) ++lowest;
      const double away = at - parabolas_[lowest].at;
      row[column] = static_cast<float>(std::sqrt(away * away + parabolas_[lowest].height));
    }
  }

 private:
  struct Parabola {
    double at;
    double height;
    double from = -std::numeric_limits<double>::infinity();  // Lowest of all from here on.
  };

  void add(Parabola parabola) {
    while (!parabolas_.empty()) {
      const Parabola& last = parabolas_.back();
      parabola.from =
          ((parabola.height + parabola.at * parabola.at) - (last.height + last.at * last.at)) /
          (2.0 * (parabola.at - last.at));
      if (parabola.from > last.from) break;
      parabolas_.pop_back();
    }
    if (parabolas_.empty()) parabola.from = -std::numeric_limits<double>::infinity();
    parabolas_.push_back(parabola);
  }

  double step_m_;
  std::vector<Parabola> parabolas_{};
};

}  // namespace

std::vector<float> distance_to(std::span<const std::uint8_t> targets, const CellLattice& lattice) {
  if (targets.size() != lattice.cells())
    throw std::invalid_argument("distance_to: targets and cells differ in number");
  std::vector<float> distance = distance_within_columns(targets, lattice);
  Envelope envelope(lattice.cell_width_m);
  const auto columns = static_cast<std::size_t>(lattice.columns);
  for (int row = 0; row < lattice.rows; ++row)
    envelope.apply(std::span(distance).subspan(lattice.index(0, row), columns));
  return distance;
}

}  // namespace groundgrid::evaluation
