#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/kernels/surface_kernels.hpp"
#include "core/method/constants.hpp"
#include "core/parallel.hpp"
#include "core/stages/plane_hierarchy.hpp"

namespace groundgrid {

/// A surface through known heights of some cells of a square: tells those that are ground from
/// those that stand on it, has a height for every other cell, and says how far off each may be.
/// Not in the paper; see docs/method.md.
class SurfaceFit {
 public:
  /// For `size` × `size` cells, row by row, x fastest; `size` is an odd number.
  /// Its tasks run on `runner`, which outlives this object.
  SurfaceFit(int size, double resolution_m, TileRunner& runner);

  /// The heights that are known, metres, one a cell, kUnknownHeight where nothing is; to be written
  /// before reject_raised() or accept_all().
  [[nodiscard]] std::span<float> heights() { return heights_; }

  /// Takes all cells with a height for ground.
  void accept_all();

  /// Fits planes again and again with less weight for the cells above them, then takes out those
  /// that still stand constants::kSurfaceStep_m above, but for terraces: patches wider than
  /// `terrace_m2`. `top` is the plane that is expected at the middle of the square.
  void reject_raised(const LocalPlane& top, double terrace_m2 = constants::kTerraceArea_m2);

  /// Whether a cell has a height and was not taken out.
  [[nodiscard]] bool is_ground(std::uint32_t cell) const {
    return standing_[cell] == Standing::on_surface;
  }
  /// After reject_raised(): takes a cell that had no part in it for ground if this height of it
  /// lies on the surface; returns whether it does.
  bool accept(std::uint32_t cell, float height);
  /// Whether a cell has a height and was taken out.
  [[nodiscard]] bool is_raised(std::uint32_t cell) const {
    return standing_[cell] == Standing::judged;
  }
  [[nodiscard]] std::span<const Standing> standing() const { return standing_; }
  /// The cells that reject_raised() took out, ascending.
  [[nodiscard]] std::span<const std::uint32_t> raised() const { return raised_; }

  /// Fits planes down to the finest blocks to those of these heights, one a cell, that are ground.
  void fit(std::span<const float> heights, const LocalPlane& top);
  /// The height of those planes at each cell.
  void evaluate(std::span<float> surface) { planes_.evaluate(0, *runner_, surface); }
  /// Calls visit(row, those planes along it) for every row of cells, some rows on each thread.
  template <typename Visit>
  void for_each_row(const Visit& visit) {
    planes_.for_each_row(0, *runner_, visit);
  }

  /// Standard deviation of the true height of the ground around these heights, metres, one a cell,
  /// after fit() of the same heights.
  void standard_deviation(std::span<const float> heights, std::span<float> deviation);

 private:
  void list_raised();
  void keep_terraces(double terrace_m2);
  void follow_raised(std::uint32_t seed);

  TileRunner* runner_;
  int size_;
  float cell_size_;
  PlaneHierarchy planes_;
  std::vector<float> heights_;         // per cell
  std::vector<float> surface_;         // per cell with a height, of the blocks that tell what rises
  std::vector<Standing> standing_;     // per cell
  std::vector<std::uint32_t> raised_;  // cells, ascending
  std::vector<std::uint32_t> patch_;   // of raised cells, in the order they were found
};

}  // namespace groundgrid
