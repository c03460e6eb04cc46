#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/plane_hierarchy.hpp"
#include "groundgrid/config.hpp"

namespace groundgrid {

/// A surface through known heights of some cells of a square: tells those that are ground from
/// those that stand on it, has a height for every other cell, and says how far off each may be.
/// Not in the paper; see docs/method.md.
class SurfaceFit {
 public:
  /// For `size` × `size` cells, row by row, x fastest; `size` is an odd number.
  SurfaceFit(int size, double cell_size_m);

  /// Forgets all heights.
  void clear();
  /// Tells a cell's height, metres. Cells come in ascending order, each once.
  void add(std::uint32_t cell, float height);

  /// Fits planes again and again with less weight for the cells above them, then takes out those
  /// that still stand Config::surface_step_m above and are no plateau. `top` is the plane that is
  /// expected at the middle of the square.
  void reject_raised(const LocalPlane& top, const Config& config);

  /// Whether a cell was told and not taken out.
  [[nodiscard]] bool is_ground(std::uint32_t cell) const {
    return standing_[cell] == Standing::on_surface;
  }
  /// Whether a cell was told and taken out.
  [[nodiscard]] bool is_raised(std::uint32_t cell) const {
    return standing_[cell] == Standing::judged;
  }
  /// The cells that were told, ascending.
  [[nodiscard]] std::span<const std::uint32_t> told() const { return told_; }

  /// Fits planes down to the finest blocks to those of these heights, one a cell, that are ground.
  void fit(std::span<const float> heights, const LocalPlane& top);
  /// The height of those planes at each cell.
  [[nodiscard]] std::span<const float> surface() const { return surface_; }

  /// Standard deviation of the true height of the ground around these heights, metres, one a cell,
  /// after fit() of the same heights.
  void standard_deviation(std::span<const float> heights, const Config& config,
                          std::span<float> deviation);

 private:
  enum class Standing : std::uint8_t { unknown, on_surface, raised, judged };

  void reweight(const Config& config);
  void find_raised(const Config& config);
  void keep_plateaus(const Config& config);
  void follow_raised(std::uint32_t seed);

  int size_;
  float cell_size_;
  PlaneHierarchy planes_;
  std::vector<float> weights_;        // per cell; 0 where nothing is known
  std::vector<float> heights_;        // per cell, where it has a weight
  std::vector<float> surface_;        // per cell
  std::vector<Standing> standing_;    // per cell
  std::vector<std::uint32_t> told_;   // cells with a height, ascending
  std::vector<std::uint32_t> patch_;  // of raised cells, in the order they were found
};

}  // namespace groundgrid
