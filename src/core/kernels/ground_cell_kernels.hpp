#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "core/map/cell_statistics.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {

/// What a cell adds to the sums over patches.
struct WeightedCell {
  float points = 0.0F;
  float min_height = 0.0F;    ///< count · minimum, metres
  float variance = 0.0F;      ///< count · variance, m²
  float own_variance = 0.0F;  ///< m²
};

/// What the sums over a cell's patch say; for every occupied cell.
struct GroundCell {
  float patch_points = 0.0F;     ///< ΣP.
  float patch_elevation = 0.0F;  ///< Eq. 3, metres above the z origin.
  float variance = 0.0F;         ///< The variance that was tested, m².
  bool observed = false;         ///< Supported, or accepted as a lone cell.
  bool ground = false;           ///< Classified as ground.
  bool lone = false;             ///< As smooth as ground, but not supported.
};

/// The window that the class of a cell depends on.
struct ClassRule {
  const WeightedCell* cells = nullptr;  ///< Of the window, row by row.
  int size = 0;
  float cell_size = 0.0F;
  const std::uint8_t* supported = nullptr;  ///< 1 for each cell that may be ground.
  std::span<const Point3f> sensors{};       ///< Distances are planar and to the nearest one.
};

/// Weighted moments of occupied cells, written to their places in the window.
void weigh_cells(std::span<const std::uint32_t> occupied, const CellStatistics* statistics,
                 WeightedCell* cells);

/// Classes of some occupied cells, ascending; element i of `answers` belongs to element i of them,
/// is_ground is the window's.
void classify_cells(std::span<const std::uint32_t> occupied, const ClassRule& rule,
                    GroundCell* answers, std::uint8_t* is_ground);

}  // namespace groundgrid
