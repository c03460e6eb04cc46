// Classification of ground cells, and the patch sums that III-D shares with it.
#include "core/stages/ground_cells.hpp"

#include <span>

namespace groundgrid {
namespace {

constexpr std::size_t kForgottenPerTile = 4096;

}  // namespace

GroundCells::GroundCells(std::size_t cells) : weighted_(cells), is_ground_(cells) {
  summarised_.reserve(cells);
  cells_.reserve(cells);
}

void GroundCells::summarise(const ScanGrid& grid, TileRunner& runner) {
  const auto forget = [&](std::size_t begin, std::size_t end) {
    for (const std::uint32_t cell : std::span(summarised_).subspan(begin, end - begin)) {
      weighted_[cell] = WeightedCell{};
      is_ground_[cell] = 0;
    }
  };
  runner.parallel_for_ranges(summarised_.size(), kForgottenPerTile, forget);
  summarised_ = grid.occupied;
  cells_.resize(grid.occupied.size());
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile,
                             [&](std::size_t begin, std::size_t end) {
                               weigh_cells(std::span(grid.occupied).subspan(begin, end - begin),
                                           grid.statistics.data(), weighted_.data());
                             });
}

void GroundCells::classify(const ScanGrid& grid, const ElevationMap& map,
                           const std::vector<std::uint8_t>& supported,
                           std::span<const Point3f> sensors, TileRunner& runner) {
  summarise(grid, runner);
  ClassRule rule;
  rule.cells = weighted_.data();
  rule.size = map.size();
  rule.cell_size = static_cast<float>(map.cell_size());
  rule.supported = supported.data();
  rule.sensors = sensors;
  runner.parallel_for_ranges(grid.occupied.size(), kCellsPerTile,
                             [&](std::size_t begin, std::size_t end) {
                               classify_cells(std::span(grid.occupied).subspan(begin, end - begin),
                                              rule, cells_.data() + begin, is_ground_.data());
                             });
}

}  // namespace groundgrid
