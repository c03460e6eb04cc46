// Which cells have enough others around them that agree, and which returns lie below those.
#include "core/cell_support.hpp"

#include <algorithm>
#include <cmath>

#include "core/point_kernels.hpp"
#include "core/window_cells.hpp"

namespace groundgrid {
namespace {

// Lowest returns belong to one surface if the slope between them is at most that of a steep
// embankment (35 degrees), plus what measurement and grass scatter by.
constexpr double kSteepest = 0.7;
constexpr double kScatter_m = 0.05;
// Below that surface, by more than a kerb or a gutter, there is no ground.
constexpr double kDepth_m = 0.3;
constexpr std::int32_t kEmpty = 1 << 30;
constexpr float kNowhere = -1e9F;
constexpr float kEverywhere = 1e9F;
constexpr std::size_t kPointsAtOnce = 2048;
// Two do on scans as they come, four where every twentieth return lies below the ground.
constexpr int kMostPasses = 8;

std::int32_t steps(double metres) {
  return static_cast<std::int32_t>(std::lrint(metres / CellStatistics::kStep_m));
}

}  // namespace

CellSupport::CellSupport(const ElevationMap& map)
    : size_(map.size()),
      lowest_(map.cells(), kEmpty),
      supported_(map.cells()),
      visited_(map.cells()),
      floor_(map.cells()),
      look_below_(map.cells(), kNowhere) {
  auto next = neighbours_.begin();
  for (int row = -kReach; row <= kReach; ++row) {
    for (int column = -kReach; column <= kReach; ++column) {
      if (row == 0 && column == 0) continue;
      const double rise = kSteepest * map.cell_size() * std::hypot(column, row);
      *next++ = {column, row, row * size_ + column, steps(kScatter_m + rise),
                 steps(kDepth_m + rise)};
    }
  }
  std::stable_sort(neighbours_.begin(), neighbours_.end(),
                   [](const Neighbour& a, const Neighbour& b) { return a.rise < b.rise; });
  for (auto* cells : {&cells_, &unsupported_, &again_, &surface_, &cut_}) cells->reserve(map.cells());
}

/// Calls visit(cell of the neighbour, Neighbour) until it returns true, within the window.
template <typename Visit>
void CellSupport::for_each_neighbour(std::uint32_t cell, int row, const Visit& visit) const {
  const int column = static_cast<int>(cell) - row * size_;
  const auto far_from_edge = [&](int i) { return i >= kReach && i < size_ - kReach; };
  const auto inside = [&](int i) { return i >= 0 && i < size_; };
  const bool all_inside = far_from_edge(column) && far_from_edge(row);
  for (const Neighbour& neighbour : neighbours_) {
    if (!all_inside && !(inside(column + neighbour.column) && inside(row + neighbour.row)))
      continue;
    if (visit(cell + static_cast<std::uint32_t>(neighbour.offset), neighbour)) return;
  }
}

void CellSupport::forget() {
  for (const std::uint32_t cell : cells_) {
    lowest_[cell] = kEmpty;
    supported_[cell] = visited_[cell] = 0;
  }
}

/// Follows the surface from a cell over its neighbours until it has enough cells or ends.
void CellSupport::follow(std::uint32_t seed, std::size_t enough) {
  surface_.assign(1, seed);
  visited_[seed] = 1;
  bool supported = surface_.size() >= enough;
  for (std::size_t next = 0; next < surface_.size() && !supported; ++next) {
    const std::uint32_t cell = surface_[next];
    const std::int32_t height = lowest_[cell];
    for_each_neighbour(cell, static_cast<int>(cell) / size_,
                       [&](std::uint32_t other, const Neighbour& neighbour) {
                         if (std::abs(lowest_[other] - height) > neighbour.rise) return false;
                         if (visited_[other] == 0) {
                           visited_[other] = 1;
                           surface_.push_back(other);
                         }
                         supported = supported_[other] != 0 || surface_.size() >= enough;
                         return supported;
                       });
  }
  if (supported)
    for (const std::uint32_t cell : surface_) supported_[cell] = 1;
}

/// Most cells lie beside one that is known to be supported.
void CellSupport::judge(std::span<const std::uint32_t> cells, std::size_t enough) {
  unsupported_.clear();
  AscendingRows rows(static_cast<std::size_t>(size_));
  for (const std::uint32_t cell : cells) {
    const std::int32_t height = lowest_[cell];
    const auto row = static_cast<int>(rows.row_of(cell));
    if (supported_[cell] == 0)
      for_each_neighbour(cell, row, [&](std::uint32_t other, const Neighbour& neighbour) {
        if (supported_[other] == 0 || std::abs(lowest_[other] - height) > neighbour.rise)
          return false;
        supported_[cell] = 1;
        return true;
      });
    if (supported_[cell] == 0 && visited_[cell] == 0) follow(cell, enough);
  }
  for (const std::uint32_t cell : cells)
    if (supported_[cell] == 0) unsupported_.push_back(cell);
}

/// Unsupported cells that reach below the supported ones beside them, and how far they may.
void CellSupport::find_floors(std::span<const std::uint32_t> cells) {
  cut_.clear();
  AscendingRows rows(static_cast<std::size_t>(size_));
  for (const std::uint32_t cell : cells) {
    std::int32_t floor = -kEmpty;
    for_each_neighbour(cell, static_cast<int>(rows.row_of(cell)),
                       [&](std::uint32_t other, const Neighbour& neighbour) {
                         if (supported_[other] != 0)
                           floor = std::max(floor, lowest_[other] - neighbour.depth);
                         return false;
                       });
    if (lowest_[cell] >= floor) continue;
    floor_[cell] = floor;
    cut_.push_back(cell);
  }
}

/// Takes the points below the floors out of the cells, whose statistics are summed anew.
void CellSupport::set_aside(BinnedPoints& bins, ScanGrid& grid) {
  for (const std::uint32_t cell : cut_) {
    grid.statistics[cell] = CellStatistics{};
    grid.is_occupied[cell] = 0;
    look_below_[cell] = kEverywhere;
  }
  const CellBand all{0, static_cast<std::uint32_t>(lowest_.size())};
  const DepthRule rule{look_below_.data(), 0.0F};
  std::uint32_t found[kPointsAtOnce + kSpareIndices];
  std::uint32_t cells[kPointsAtOnce];
  std::int32_t heights[kPointsAtOnce];
  for (std::size_t begin = 0; begin < bins.cell.size(); begin += kPointsAtOnce) {
    std::uint32_t* cell = bins.cell.data() + begin;
    const std::int32_t* z = bins.z.data() + begin;
    const std::size_t count = std::min(kPointsAtOnce, bins.cell.size() - begin);
    const std::size_t in_cut = find_deep({cell, z, count}, rule, found);
    std::size_t kept = 0;
    for (const std::uint32_t i : std::span(found, in_cut)) {
      cells[kept] = cell[i];
      heights[kept] = z[i];
      if (z[i] < floor_[cell[i]])
        cell[i] |= BinnedPoints::kOutlier;
      else
        ++kept;
    }
    add_points({cells, heights, kept}, all, grid.statistics.data(), grid.is_occupied.data());
  }
  grid.occupied.clear();
  list_occupied(grid);
  for (const std::uint32_t cell : cut_) {
    look_below_[cell] = kNowhere;
    lowest_[cell] = grid.is_occupied[cell] != 0 ? grid.statistics[cell].min : kEmpty;
  }
}

void CellSupport::find(const Config& config, BinnedPoints& bins, ScanGrid& grid) {
  const auto enough = static_cast<std::size_t>(config.min_support_cells);
  forget();
  cells_ = grid.occupied;
  for (const std::uint32_t cell : cells_) lowest_[cell] = grid.statistics[cell].min;
  judge(cells_, enough);
  // What is left of a cell may support others, and show what lies below it.
  for (int pass = 0; pass < kMostPasses; ++pass) {
    find_floors(unsupported_);
    if (cut_.empty()) return;
    set_aside(bins, grid);
    again_.swap(unsupported_);
    std::erase_if(again_, [&](std::uint32_t cell) { return lowest_[cell] == kEmpty; });
    for (const std::uint32_t cell : again_) visited_[cell] = 0;
    judge(again_, enough);
  }
}

}  // namespace groundgrid
