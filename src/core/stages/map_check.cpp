#include "core/stages/map_check.hpp"

#include <algorithm>
#include <cstddef>

#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

using namespace constants;

/// How the flat cells of a scan lie to what the map remembers of them.
struct Comparison {
  std::size_t known = 0;
  std::size_t above = 0;
  std::size_t below = 0;
};

Comparison compare(const ScanGrid& grid, const ElevationMap& map) {
  const std::int32_t flat = in_steps(kFlatColumn_m);
  Comparison cells;
  for (const std::uint32_t cell : grid.occupied) {
    const CellStatistics& seen = grid.statistics[cell];
    if (map.confidence()[cell] < kRemembered || seen.max - seen.min > flat) continue;
    const float offset = lowest_m(seen) - map.height()[cell];
    ++cells.known;
    if (offset > kMapOffset_m) ++cells.above;
    if (offset < -kMapOffset_m) ++cells.below;
  }
  return cells;
}

}  // namespace

bool contradicts_map(const BinnedPoints& bins, const ScanGrid& grid, const ElevationMap& map) {
  if (map.blank()) return false;
  const Comparison cells = compare(grid, map);
  const auto most = static_cast<double>(std::max(cells.above, cells.below));
  if (cells.known >= kComparedCells)
    return most > kContradicting * static_cast<double>(cells.known);
  // Few cells are left if the points have sunk below the map and are outliers to it.
  std::size_t outliers = 0;
  std::size_t points = 0;
  for (const std::uint32_t cell : bins.cell) {
    points += cell != BinnedPoints::kNoCell ? 1 : 0;
    outliers += cell >= BinnedPoints::kOutlier && cell != BinnedPoints::kNoCell ? 1 : 0;
  }
  return static_cast<double>(outliers) > kSunkPoints * static_cast<double>(points);
}

}  // namespace groundgrid
