#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/map/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/stages/rasterization.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Up to where a cell's points are ground.
struct alignas(8) CellLimit {
  float level = 0.0F;      ///< Height from which points are measured, metres above the z origin.
  float threshold = 0.0F;  ///< Greatest height of a ground point above the level, metres.

  /// Lets the ground end at this height above the z origin, metres, if it does not before.
  void lower_to(float height) { threshold = std::min(threshold, height - level); }
};

/// Chooses level and threshold of every occupied cell for the segmentation (paper III-F).
class CellLimits {
 public:
  /// For tasks on as many threads as `runner` has.
  CellLimits(const ElevationMap& map, const TileRunner& runner);

  /// The default's rule: what stands in the cell's column decides. A column with returns that rise
  /// from the ground (higher than constants::kTall_m, but below kOverhang_m, so that crowns and
  /// bridges do not count) gets a tight threshold, any other a wide one. The level is the map's
  /// height, which rests on minima, raised to the mean of the ground points around.
  void choose_by_column(const BinnedPoints& bins, const ScanGrid& grid, const ElevationMap& map,
                        const Config& config, TileRunner& runner);

  /// One a cell of the window; only those of occupied cells are of this scan.
  [[nodiscard]] const std::vector<CellLimit>& limits() const { return limits_; }
  [[nodiscard]] std::span<CellLimit> limits() { return limits_; }

 private:
  /// What the points of one cell say relative to the map's height.
  struct Column {
    std::int64_t near_ground_sum =
        0;                         ///< Heights of the points near it, above it, steps of 0.1 mm.
    std::int32_t near_ground = 0;  ///< Points within the band around the height.
    std::int32_t rising = 0;       ///< Points that rise from the ground.
  };
  /// A cell that is not settled, and where its weights are.
  struct MixedCell {
    std::uint32_t cell = 0;
    std::uint32_t place = 0;
  };
  void settle_cells(const ScanGrid& grid, const ElevationMap& map, const ColumnRule& rule,
                    float threshold, std::vector<MixedCell>& mixed);
  void count_columns(const BinnedPoints& bins, const ColumnRule& rule);
  void judge_columns(const ScanGrid& grid, std::span<const MixedCell> mixed);
  void clear_offsets(const CellBand& band);
  void offer_offset(std::size_t place, const Column& column);
  [[nodiscard]] static bool rises(const Column& column);
  void raise_row(const ScanGrid& grid, const ElevationMap& map, std::size_t row);

  std::size_t size_;
  std::vector<CellLimit> limits_;
  std::vector<std::int32_t> heights_;  // per cell, steps; kSettled where no point is looked at
  std::vector<Column> columns_;        // per cell, of those that are not settled
  std::array<std::vector<MixedCell>, kMaxBands> mixed_;  // those cells, ascending, by band
  // See OffsetGrid.
  std::vector<float> weights_;
  std::vector<float> weighted_steps_;
  std::vector<std::uint32_t> collected_;  // cells whose weights may be more than 0, ascending
};

}  // namespace groundgrid
