// The thresholds of the point cloud segmentation, paper III-F, chosen cell by cell.
#include "core/stages/cell_limits.hpp"

#include <algorithm>
#include <cmath>

#include "core/kernels/offset_kernels.hpp"
#include "core/kernels/point_kernels.hpp"
#include "core/map/window_cells.hpp"
#include "core/method/constants.hpp"

namespace groundgrid {
namespace {

constexpr float kStep_m = static_cast<float>(CellStatistics::kStep_m);
using namespace constants;

constexpr std::size_t kRowsPerTile = 16;
constexpr std::size_t kSelectedAtOnce = 1024;
// No point is so far up that its height over this one counts: 32 bits are enough for both.
constexpr std::int32_t kSettled = -1'500'000'000;

}  // namespace

CellLimits::CellLimits(const ElevationMap& map, const TileRunner& runner)
    : size_(static_cast<std::size_t>(map.size())),
      limits_(map.cells()),
      heights_(map.cells(), kSettled),
      columns_(map.cells()),
      weights_(OffsetGrid::places(size_)),
      weighted_steps_(OffsetGrid::places(size_)) {
  collected_.reserve(map.cells());
  const std::size_t bands = band_count(runner);
  for (std::size_t band = 0; band < bands; ++band) mixed_[band].reserve(map.cells() / bands + 1);
}

/// Settles the cells whose points all lie near the ground: their sums say all that is asked, and
/// nothing rises there. The others are listed.
void CellLimits::settle_cells(const ScanGrid& grid, const ElevationMap& map, const ColumnRule& rule,
                              float threshold, std::vector<MixedCell>& mixed) {
  const CellStatistics* statistics = grid.statistics.data();
  const float* levels = map.height().data();
  CellLimit* limits = limits_.data();
  std::int32_t* heights = heights_.data();
  mixed.clear();
  AscendingRows rows(size_, rule.band.begin);
  for (const std::uint32_t cell : cells_in(grid.occupied, rule.band)) {
    const CellStatistics& seen = statistics[cell];
    const std::int32_t height = limited_steps(levels[cell]);
    const std::size_t place = OffsetGrid::place(size_, cell, rows.row_of(cell));
    const std::int64_t lowest = std::int64_t{seen.min} - height;
    const std::int64_t highest = std::int64_t{seen.max} - height;
    const bool settled =
        lowest > -rule.band_below && highest < rule.band_above && highest <= rule.tall;
    limits[cell].threshold = threshold;
    heights[cell] = settled ? kSettled : height;
    if (settled) {
      const auto count = static_cast<std::int32_t>(seen.count);
      offer_offset(place, {seen.sum - std::int64_t{height} * count, count, 0});
    } else {
      columns_[cell] = {};
      mixed.push_back({cell, static_cast<std::uint32_t>(place)});
    }
  }
}

/// Counts the points of the columns of a band that are not settled.
void CellLimits::count_columns(const BinnedPoints& bins, const ColumnRule& rule) {
  Column* columns = columns_.data();
  const auto add = [&](std::uint32_t cell, std::int32_t above) {
    Column& column = columns[cell];
    if (above < rule.band_above) {
      ++column.near_ground;
      column.near_ground_sum += above;
    } else {
      ++column.rising;
    }
  };
  std::uint32_t cells[kSelectedAtOnce + kSpareIndices];
  std::int32_t above[kSelectedAtOnce + kSpareIndices];
  for (std::size_t i = 0; i < bins.cell.size(); i += kSelectedAtOnce) {
    const std::size_t count = std::min(kSelectedAtOnce, bins.cell.size() - i);
    const std::size_t found =
        select_columns({bins.cell.data() + i, bins.z.data() + i, count}, rule, cells, above);
    for (std::size_t k = 0; k < found; ++k) add(cells[k], above[k]);
  }
}

/// What the ground points of a cell add to the mean height of those around.
void CellLimits::offer_offset(std::size_t place, const Column& column) {
  const auto points = static_cast<float>(column.near_ground);
  const float share = 1.0F / (1.0F + points / kCellWeight);
  weights_[place] = share * points;
  weighted_steps_[place] = share * static_cast<float>(column.near_ground_sum);
}

/// Thresholds and offsets of the cells that are not settled.
void CellLimits::judge_columns(const ScanGrid& grid, std::span<const MixedCell> mixed) {
  const std::int32_t tall = limited_steps(kTall_m);
  for (const auto& [cell, place] : mixed) {
    if (rises(columns_[cell])) limits_[cell].threshold = kTallThreshold_m;
    // Where something stands its feet would pass for ground: such cells take the level of others.
    if (grid.statistics[cell].max - heights_[cell] <= tall) offer_offset(place, columns_[cell]);
  }
}

/// Forgets what the cells of the scan before offered.
void CellLimits::clear_offsets(const CellBand& band) {
  AscendingRows rows(size_, band.begin);
  for (const std::uint32_t cell : cells_in(collected_, band)) {
    const std::size_t place = OffsetGrid::place(size_, cell, rows.row_of(cell));
    weights_[place] = weighted_steps_[place] = 0.0F;
  }
}

/// Whether something stands in the column, and not only a blade of grass or two.
bool CellLimits::rises(const Column& column) {
  return column.rising > 0 && static_cast<double>(column.rising) > kTallShare * column.near_ground;
}

/// Raises the levels of a row's occupied cells to the mean of the ground points around.
void CellLimits::raise_row(const ScanGrid& grid, const ElevationMap& map, std::size_t row) {
  const std::size_t first = row * size_;
  raise_levels(
      {weights_.data(), weighted_steps_.data(), size_}, row, kStep_m,
      {grid.is_occupied.data() + first, map.height().data() + first, &limits_[first].level});
}

void CellLimits::choose_by_column(const BinnedPoints& bins, const ScanGrid& grid,
                                  const ElevationMap& map, const Config& config,
                                  TileRunner& runner) {
  const ColumnRule rule{heights_.data(),
                        {},
                        limited_steps(static_cast<float>(kReflectionDepth_m)),
                        limited_steps(kLevelBand_m),
                        limited_steps(kTall_m),
                        limited_steps(kOverhang_m)};
  const auto threshold = static_cast<float>(config.labels.ground_threshold_m);
  for_each_band(limits_.size(), runner, [&](const CellBand& band, std::size_t number) {
    ColumnRule own = rule;
    own.band = band;
    clear_offsets(band);
    settle_cells(grid, map, own, threshold, mixed_[number]);
    if (!mixed_[number].empty()) count_columns(bins, own);
    judge_columns(grid, mixed_[number]);
  });
  collected_ = grid.occupied;
  runner.parallel_for_ranges(static_cast<std::size_t>(size_), kRowsPerTile,
                             [&](std::size_t begin, std::size_t end) {
                               for (std::size_t row = begin; row < end; ++row)
                                 raise_row(grid, map, row);
                             });
}

}  // namespace groundgrid
