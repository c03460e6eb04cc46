#pragma once

#include <cstddef>
#include <cstdint>

#include "core/map/cell_statistics.hpp"
#include "core/point_transform.hpp"
#include "groundgrid/label.hpp"

namespace groundgrid {

/// Some points, one array a coordinate, metres.
struct PointBlock {
  static constexpr std::size_t kMost = 512;
  alignas(64) float x[kMost];
  alignas(64) float y[kMost];
  alignas(64) float z[kMost];
};

/// What decides whether and where a point lies in the window.
struct BinRule {
  float extent_m = 0.0F;
  float inverse_cell_size = 0.0F;
  std::int32_t size = 0;
  float height_limit_m = 0.0F;
  float min_range_squared = 0.0F;  ///< m²; points nearer to their origin are in no cell.
  PointTransform transform{};      ///< From the points' frame to the window's.
};

/// Points that are binned: cell and height of each; see BinnedPoints.
struct BinBlock {
  alignas(64) std::uint32_t cell[PointBlock::kMost];
  alignas(64) std::int32_t z[PointBlock::kMost];
};

/// Moves points to the window frame and bins them. Whole blocks are worked on, whatever they hold.
void bin_block(const PointBlock& points, const BinRule& rule, BinBlock& bins);

/// The same for records of three or four floats, x, y and z the first of them, so many together.
constexpr std::size_t kRecordsTogether = 64;
struct PackedRecords {
  const float* data = nullptr;
  std::size_t floats = 4;  ///< Of a record, 3 or 4.
  std::size_t count = 0;   ///< A multiple of kRecordsTogether.
};
void bin_records(const PackedRecords& records, const BinRule& rule, std::uint32_t* cells,
                 std::int32_t* z);

/// So many indices more than points must fit where a function here writes those it found.
constexpr std::size_t kSpareIndices = 64;

/// Points that were binned; see BinnedPoints.
struct BinnedRange {
  const std::uint32_t* cells = nullptr;
  const std::int32_t* z = nullptr;
  std::size_t count = 0;
};

/// Cells [begin, end) that one task owns: what it writes to them needs no lock, and sums of whole
/// numbers come out the same whoever adds them in whatever order.
struct CellBand {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

/// Adds points to the moments of their cells, those of the band, and marks the cells.
void add_points(const BinnedRange& points, CellBand band, CellStatistics* statistics,
                std::uint8_t* is_occupied);

/// How far below the height of their cell points are looked at.
struct DepthRule {
  const float* heights = nullptr;  ///< Per cell, metres.
  float min_depth_m = 0.0F;
};

/// Indices of the points at least min_depth_m below the height of their cell; returns how many.
std::size_t find_deep(const BinnedRange& points, const DepthRule& rule, std::uint32_t* found);

/// Which points say something about the column of their cell.
struct ColumnRule {
  const std::int32_t* heights = nullptr;  ///< Per cell, steps; see CellLimits.
  CellBand band{};                        ///< Cells that count, at least one.
  std::int32_t band_below = 0;            ///< Steps.
  std::int32_t band_above = 0;
  std::int32_t tall = 0;
  std::int32_t overhang = 0;
};

/// Cells of the points within the band around their cell's height, or between tall and overhang,
/// and their heights above it in steps; returns how many.
std::size_t select_columns(const BinnedRange& points, const ColumnRule& rule,
                           std::uint32_t* found_cells, std::int32_t* found_above);

/// Points with each label.
struct LabelCounts {
  std::size_t ground = 0;
  std::size_t obstacle = 0;
  std::size_t outlier = 0;
  std::size_t unknown = 0;
};

/// Labels and heights above ground of some points, from levels and thresholds of their cells:
/// limits[2 c] and limits[2 c + 1]. Indices of outliers, whose answers are the caller's, go to
/// `outliers`.
LabelCounts label_points(const BinnedRange& points, const float* limits, Label* labels,
                         float* height_above_ground, std::uint32_t* outliers);

}  // namespace groundgrid
