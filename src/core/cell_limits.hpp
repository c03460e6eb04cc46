#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/parallel.hpp"
#include "core/rasterization.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Up to where a cell's points are ground.
struct CellLimit {
  float level = 0.0F;      ///< Height from which points are measured, metres above the z origin.
  float threshold = 0.0F;  ///< Greatest height of a ground point above the level, metres.
};

/// Chooses level and threshold of every occupied cell for the segmentation (paper III-F).
class CellLimits {
 public:
  explicit CellLimits(std::size_t cells) : limits_(cells), columns_(cells), offsets_(cells) {
    collected_.reserve(cells);
  }

  /// The paper's rule: the level is the map's height; h_g for ground cells, h_o for all others.
  void choose_by_class(const ScanGrid& grid, const std::vector<std::uint8_t>& is_ground,
                       const ElevationMap& map, const Config& config);

  /// The default's rule: what stands in the cell's column decides. A column with returns that rise
  /// from the ground (higher than tall_height_m, but below overhang_height_m, so that crowns and
  /// bridges do not count) gets a tight threshold, any other a wide one. The level is the map's
  /// height, which rests on minima, raised to the mean of the ground points around.
  void choose_by_column(const BinnedPoints& bins, std::span<const Label> labels,
                        const ScanGrid& grid, const ElevationMap& map, const Config& config,
                        TileRunner& runner);

  /// Lets the cell's ground end at this height above the z origin, metres, if it does not before.
  void lower(std::uint32_t cell, float height) {
    CellLimit& limit = limits_[cell];
    limit.threshold = std::min(limit.threshold, height - limit.level);
  }

  /// One a cell of the window; only those of occupied cells are of this scan.
  [[nodiscard]] const std::vector<CellLimit>& limits() const { return limits_; }

 private:
  /// What the points of one cell say relative to the map's height, in steps of 0.1 mm.
  struct Column {
    std::int32_t height = 0;
    std::int32_t near_ground = 0;      ///< Points within the band around the height.
    std::int64_t near_ground_sum = 0;  ///< Their heights above it.
    std::int32_t rising = 0;           ///< Points that rise from the ground.
  };
  /// What the cell adds to the mean height of the ground points around, in points and steps.
  struct Offset {
    float weight = 0.0F;
    float weighted_steps = 0.0F;
  };
  void collect_columns(const BinnedPoints& bins, std::span<const Label> labels,
                       const ScanGrid& grid, const ElevationMap& map, const Config& config,
                       TileRunner& runner);
  [[nodiscard]] static bool rises(const Column& column, const Config& config);
  [[nodiscard]] float mean_offset(int column, int row, int size) const;

  std::vector<CellLimit> limits_;
  std::vector<Column> columns_;
  std::vector<Offset> offsets_;
  std::vector<std::uint32_t> collected_;  // cells of offsets_ that hold something
};

}  // namespace groundgrid
