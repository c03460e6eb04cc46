#pragma once

#include <cstdint>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/ground_cells.hpp"

namespace groundgrid {

/// Takes back ground cells that stand on something: the feet of walls, tops of hedges, car roofs
/// are as flat as ground, and only their surroundings tell. Not in the paper; see docs/method.md.
///
/// The envelope is the highest surface that nowhere rises steeper than a limit and nowhere runs
/// above a ground cell (both measured from the trend of the ground some metres around, so that a
/// steep road or hillside is not a rise). A ground cell that stands a step above it is none.
class GroundEnvelope {
 public:
  explicit GroundEnvelope(const ElevationMap& map);

  void reject_raised(const ScanGrid& grid, const ElevationMap& map, const Plane& vehicle_plane,
                     const Config& config, GroundCells& ground_cells);

 private:
  /// A ground cell of this scan.
  struct Candidate {
    std::uint32_t index = 0;  ///< Into ScanGrid::occupied.
    std::uint32_t cell = 0;
    std::uint32_t block = 0;
    float height = 0.0F;  ///< Above the vehicle's plane, then above the trend, metres.
  };

  void list_candidates(const ScanGrid& grid, const ElevationMap& map, const Plane& vehicle_plane,
                       const GroundCells& ground_cells);
  void find_block_medians();
  [[nodiscard]] float median_around(int block_column, int block_row) const;
  void find_references();
  [[nodiscard]] float trend(std::uint32_t cell) const;
  void spread(float rise);

  // Blocks of cells, some metres wide: what most ground cells of a block and of its neighbours say
  // tells true ground from reflections below it, which must not pull the envelope down.
  // Odd, and one of them around the vehicle's cell, so that no direction is special.
  static constexpr int kBlockCells = 9;
  static constexpr std::size_t kMinBlockCandidates = 3;

  [[nodiscard]] int block_of(int column_or_row) const {
    return (column_or_row + before_first_) / kBlockCells;
  }

  int size_;
  int blocks_;        ///< A side.
  int before_first_;  ///< Cells by which the first block begins before the map.
  std::vector<float> envelope_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> block_begin_;
  std::vector<float> block_heights_;
  std::vector<float> block_median_;
  std::vector<float> block_reference_;
};

}  // namespace groundgrid
