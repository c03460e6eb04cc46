#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/method/constants.hpp"
#include "core/stages/rasterization.hpp"

namespace groundgrid {

/// Bounds what a few returns can do. A cell is supported if its lowest return and those of the
/// cells around it form a surface of constants::kSupportCells cells or more. Returns of other
/// cells that lie below the supported surface beside them are set aside before anything is computed
/// from them, and no unsupported cell is ground. Not in the paper; see docs/method.md.
class CellSupport {
 public:
  explicit CellSupport(const ElevationMap& map);

  /// Finds the supported cells of this scan, marks the points that are set aside as outliers and
  /// takes them out of the grid.
  void find(BinnedPoints& bins, ScanGrid& grid);

  /// 1 for each supported cell of the window, in this scan.
  [[nodiscard]] const std::vector<std::uint8_t>& is_supported() const { return supported_; }

 private:
  static constexpr int kReach = constants::kSupportReach;
  static constexpr std::size_t kNeighbours = (2 * kReach + 1) * (2 * kReach + 1) - 1;
  struct Neighbour {
    int column = 0;  ///< Relative to the cell.
    int row = 0;
    std::int32_t offset = 0;  ///< Of the index.
    std::int32_t rise = 0;    ///< Heights of one surface differ by this at most, steps.
    std::int32_t depth = 0;   ///< Returns this far below a supported neighbour are no ground.
  };

  template <typename Visit>
  void for_each_neighbour(std::uint32_t cell, int row, const Visit& visit) const;
  void forget();
  void judge_all();
  bool follow(std::uint32_t seed, std::uint8_t visit);
  void find_floors();
  void set_aside(BinnedPoints& bins, ScanGrid& grid);
  void judge_cut(std::uint8_t visit);

  int size_;
  std::array<Neighbour, kNeighbours> neighbours_{};  // the nearest ones first
  std::vector<std::int32_t> lowest_;                 // per cell, steps; kEmpty without points
  std::vector<std::uint8_t> supported_;              // per cell
  std::vector<std::uint8_t> visited_;                // per cell: the last visit that came by
  std::vector<std::uint32_t> cells_;                 // the occupied cells, ascending
  std::vector<std::uint32_t> unsupported_;           // cells to find floors for, ascending
  std::vector<std::uint32_t> newly_;                 // cells that became supported by a cut
  std::vector<std::uint32_t> surface_;               // cells that hang together, as they are found
  std::vector<std::uint32_t> cut_;                   // cells with returns below their floor
  std::vector<std::int32_t> floor_;                  // per cell of cut_, steps
  std::vector<float> look_below_;                    // per cell, metres; see DepthRule
};

}  // namespace groundgrid
