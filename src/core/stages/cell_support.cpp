// Which cells have enough others around them that agree, and which returns lie below those.
#include "core/stages/cell_support.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "core/kernels/point_kernels.hpp"
#include "core/map/window_cells.hpp"
#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

using namespace constants;

constexpr std::int32_t kEmpty = 1 << 30;
constexpr float kNowhere = -1e9F;
constexpr float kEverywhere = 1e9F;
constexpr std::size_t kCutAtOnce = 2048;

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
      *next++ = {column, row, row * size_ + column, in_steps(kScatter_m + rise),
                 in_steps(kReflectionDepth_m + rise)};
    }
  }
  std::sort(neighbours_.begin(), neighbours_.end(), [](const Neighbour& a, const Neighbour& b) {
    return std::tie(a.rise, a.offset) < std::tie(b.rise, b.offset);
  });
  for (auto* cells : {&cells_, &unsupported_, &newly_, &surface_, &cut_})
    cells->reserve(map.cells());
}

/// Calls visit(cell of the neighbour, Neighbour) until it returns true, within the window.
template <typename Visit>
void CellSupport::for_each_neighbour(std::uint32_t cell, int row, const Visit& visit) const {
  const int column = static_cast<int>(cell) - row * size_;
  const auto far_from_edge = [&](int i) { return i >= kReach && i < size_ - kReach; };
  const auto inside = [&](int i) { return i >= 0 && i < size_; };
  if (far_from_edge(column) && far_from_edge(row)) {
    for (const Neighbour& neighbour : neighbours_)
      if (visit(cell + static_cast<std::uint32_t>(neighbour.offset), neighbour)) return;
    return;
  }
  for (const Neighbour& neighbour : neighbours_)
    if (inside(column + neighbour.column) && inside(row + neighbour.row) &&
        visit(cell + static_cast<std::uint32_t>(neighbour.offset), neighbour))
      return;
}

void CellSupport::forget() {
  for (const std::uint32_t cell : cells_) {
    lowest_[cell] = kEmpty;
    supported_[cell] = visited_[cell] = 0;
  }
}

/// Follows the surface from a cell over its neighbours until it has enough cells or ends; returns
/// whether it is supported, and then so are the cells found.
bool CellSupport::follow(std::uint32_t seed, std::uint8_t visit) {
  surface_.assign(1, seed);
  visited_[seed] = visit;
  bool supported = surface_.size() >= kSupportCells;
  for (std::size_t next = 0; next < surface_.size() && !supported; ++next) {
    const std::uint32_t cell = surface_[next];
    const std::int32_t height = lowest_[cell];
    for_each_neighbour(cell, static_cast<int>(cell) / size_,
                       [&](std::uint32_t other, const Neighbour& neighbour) {
                         if (std::abs(lowest_[other] - height) > neighbour.rise) return false;
                         if (visited_[other] != visit) {
                           visited_[other] = visit;
                           surface_.push_back(other);
                         }
                         supported = supported_[other] != 0 || surface_.size() >= kSupportCells;
                         return supported;
                       });
  }
  if (supported)
    for (const std::uint32_t cell : surface_) supported_[cell] = 1;
  return supported;
}

/// Most cells lie beside one that is known to be supported.
void CellSupport::judge_all() {
  unsupported_.clear();
  AscendingRows rows(static_cast<std::size_t>(size_));
  for (const std::uint32_t cell : cells_) {
    const auto row = static_cast<int>(rows.row_of(cell));
    if (supported_[cell] != 0) continue;
    const std::int32_t height = lowest_[cell];
    for_each_neighbour(cell, row, [&](std::uint32_t other, const Neighbour& neighbour) {
      if (supported_[other] == 0 || std::abs(lowest_[other] - height) > neighbour.rise)
        return false;
      supported_[cell] = 1;
      return true;
    });
    if (supported_[cell] == 0 && visited_[cell] == 0) follow(cell, 1);
    if (supported_[cell] == 0) unsupported_.push_back(cell);
  }
}

/// The cells that returns were cut from may now be supported, and support others. `unsupported_`
/// becomes the cells beside those.
void CellSupport::judge_cut(std::uint8_t visit) {
  newly_.clear();
  for (const std::uint32_t cell : cut_)
    if (lowest_[cell] != kEmpty && visited_[cell] != visit && follow(cell, visit))
      newly_.insert(newly_.end(), surface_.begin(), surface_.end());
  unsupported_.clear();
  for (std::size_t next = 0; next < newly_.size(); ++next) {
    const std::uint32_t cell = newly_[next];
    for_each_neighbour(cell, static_cast<int>(cell) / size_,
                       [&](std::uint32_t other, const Neighbour& neighbour) {
                         if (supported_[other] != 0 || lowest_[other] == kEmpty) return false;
                         if (std::abs(lowest_[other] - lowest_[cell]) > neighbour.rise) {
                           unsupported_.push_back(other);
                         } else {
                           supported_[other] = 1;
                           newly_.push_back(other);
                         }
                         return false;
                       });
  }
  std::sort(unsupported_.begin(), unsupported_.end());
  unsupported_.erase(std::unique(unsupported_.begin(), unsupported_.end()), unsupported_.end());
  std::erase_if(unsupported_, [&](std::uint32_t cell) { return supported_[cell] != 0; });
}

/// Unsupported cells that reach below the supported ones beside them, and how far they may.
void CellSupport::find_floors() {
  cut_.clear();
  AscendingRows rows(static_cast<std::size_t>(size_));
  for (const std::uint32_t cell : unsupported_) {
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
  std::uint32_t found[kCutAtOnce + kSpareIndices];
  std::uint32_t cells[kCutAtOnce];
  std::int32_t heights[kCutAtOnce];
  for (std::size_t begin = 0; begin < bins.cell.size(); begin += kCutAtOnce) {
    std::uint32_t* cell = bins.cell.data() + begin;
    const std::int32_t* z = bins.z.data() + begin;
    const std::size_t count = std::min(kCutAtOnce, bins.cell.size() - begin);
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
  for (const std::uint32_t cell : cut_) {
    look_below_[cell] = kNowhere;
    lowest_[cell] = grid.is_occupied[cell] != 0 ? grid.statistics[cell].min : kEmpty;
  }
}

void CellSupport::find(BinnedPoints& bins, ScanGrid& grid) {
  forget();
  cells_ = grid.occupied;
  for (const std::uint32_t cell : cells_) lowest_[cell] = grid.statistics[cell].min;
  judge_all();
  // What is left of a cell may support others, and show what lies below it.
  for (int pass = 0; pass < kSupportPasses; ++pass) {
    find_floors();
    if (cut_.empty()) break;
    set_aside(bins, grid);
    judge_cut(static_cast<std::uint8_t>(pass + 2));
  }
  std::erase_if(grid.occupied, [&](std::uint32_t cell) { return grid.is_occupied[cell] == 0; });
}

}  // namespace groundgrid
