#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/stages/cell_limits.hpp"
#include "core/stages/rasterization.hpp"
#include "groundgrid/config.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Finds the cells that a step of the ground runs through, such as a kerb, for those who cannot
/// climb it. Not in the paper; see docs/method.md.
class StepEdges {
 public:
  explicit StepEdges(const ElevationMap& map) : size_(map.size()) {}

  /// Lowers the limits of cells at a step higher than max_step_m: more than half of that above the
  /// lower side of the step their points are obstacles. What is ground, the limits say so far.
  void lower_limits(const BinnedPoints& bins, const ScanGrid& grid, const Config& config,
                    TileRunner& runner, std::span<CellLimit> limits);

 private:
  /// Heights of the ground points of a cell, in steps of 0.1 mm.
  struct Moments {
    std::int64_t sum = 0;
    std::uint64_t sum_squares = 0;
    std::uint32_t count = 0;
  };
  /// The same in metres.
  struct Level {
    float mean = 0.0F;
    float variance = 0.0F;
    std::uint32_t count = 0;
  };
  /// The ground on both sides of a cell in one direction.
  struct Profile {
    float before = 0.0F;   ///< Height of the side it comes from.
    float rise = 0.0F;     ///< From there to the other side.
    float slope = 0.0F;    ///< What the sides themselves rise over the same length.
    float scatter = 0.0F;  ///< Variance of the heights of both sides' points.
    float weight = 0.0F;   ///< In points; 0 where a side was not seen.
  };
  struct Step {
    float height = 0.0F;  ///< Less what may be chance.
    float low = 0.0F;     ///< Height of its lower side over the z origin.
    int towards = 0;      ///< Direction in which it rises, eighths of a turn.
  };
  struct Direction {
    int x = 0;
    int y = 0;
  };

  void collect(const BinnedPoints& bins, const ScanGrid& grid, TileRunner& runner,
               std::span<const CellLimit> limits);
  [[nodiscard]] Level level_at(int column, int row) const;
  [[nodiscard]] Profile profile_along(int column, int row, Direction along) const;
  [[nodiscard]] Step step_along(int column, int row, Direction along) const;
  [[nodiscard]] Step highest_step(std::uint32_t cell) const;
  [[nodiscard]] bool goes_on(std::uint32_t cell, float max_step) const;

  int size_;
  // One a cell, from the first call on.
  std::vector<Moments> moments_;
  std::vector<Level> levels_;
  std::vector<Step> steps_;
  std::vector<std::uint32_t> collected_;  // cells that hold something
};

}  // namespace groundgrid
