#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "core/map/cell_statistics.hpp"

namespace groundgrid::geotiff {

/// Cells side by side in one row of a TerrainView.
struct CellSpan {
  std::span<const float> relative_height;
  std::span<const float> confidence;
  std::span<const CellStatistics> statistics;
  std::span<const std::uint32_t> points_around;  ///< Of count_points_around().
  double z_origin_m;
};

/// What a drive has told about kSide × kSide cells, row by row, x fastest, row 0 in the south.
/// Plain numbers without padding, so that a tile goes to disk and back as its bytes.
struct MosaicTile {
  static constexpr int kSide = 128;
  static constexpr std::size_t kCells = std::size_t{kSide} * kSide;

  std::array<double, kCells> weighted_height{};  ///< Sum of confidence · height, m.
  std::array<double, kCells> weight{};           ///< Sum of confidence.
  std::array<float, kCells> confidence{};        ///< Highest that there was.
  std::array<std::uint32_t, kCells> points{};    ///< Sum; stays at its greatest value once there.
  std::array<std::uint32_t, kCells> most_points_around{};  ///< Of a single scan.

  /// Adds one scan's cells, which lie in one row from (column, row) on.
  void add(std::size_t column, std::size_t row, const CellSpan& cells);

 private:
  void add_heights(std::size_t place, std::span<const float> relative_heights,
                   std::span<const float> told, double z_origin_m);
  void add_points(std::size_t place, std::span<const CellStatistics> statistics,
                  std::span<const std::uint32_t> around);
};

}  // namespace groundgrid::geotiff
