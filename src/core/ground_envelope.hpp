#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/elevation_map.hpp"
#include "core/ground_cells.hpp"
#include "core/parallel.hpp"

namespace groundgrid {

/// Takes back ground cells that stand on something: the feet of walls, tops of hedges, car roofs
/// are as flat as ground, and only their surroundings tell. Not in the paper; see docs/method.md.
///
/// The envelope is the highest surface that nowhere rises steeper than a limit and nowhere runs
/// above a ground cell (both measured from the trend of the ground some metres around, so that a
/// steep road or hillside is not a rise). A ground cell that stands a step above it is none.
class GroundEnvelope {
 public:
  /// Its tasks run on `runner`, which outlives this object.
  GroundEnvelope(const ElevationMap& map, TileRunner& runner);

  void reject_raised(const ScanGrid& grid, const ElevationMap& map, const Plane& vehicle_plane,
                     const Config& config, GroundCells& ground_cells);

 private:
  /// A ground cell of this scan.
  struct Candidate {
    std::uint32_t index = 0;  ///< Into ScanGrid::occupied.
    std::uint32_t cell = 0;
    std::uint32_t block = 0;
    std::uint16_t column = 0;
    std::uint16_t row = 0;
    float height = 0.0F;     ///< Above the vehicle's plane, metres.
    std::int32_t steps = 0;  ///< Above the trend, steps of 0.1 mm.
  };
  /// The candidates' rows and columns, the last ones too.
  struct Box {
    int left = 0;
    int right = 0;
    int bottom = 0;
    int top = 0;
    [[nodiscard]] std::size_t columns() const { return static_cast<std::size_t>(right - left + 1); }
  };
  /// Where the middle of a row or column lies between the middles of two blocks, and its own block.
  struct BlockPlace {
    int own = 0;
    int before = 0;
    float share_after = 0.0F;
  };

  void list_candidates(const ScanGrid& grid, const ElevationMap& map, const Plane& vehicle_plane,
                       const GroundCells& ground_cells);
  void find_block_medians();
  void find_references();
  [[nodiscard]] BlockPlace place_of(int column_or_row) const;
  [[nodiscard]] float trend(const Candidate& candidate) const;
  void clear_box();
  void measure_from_trend(const Config& config);
  void spread(float rise);

  // Blocks of cells, some metres wide: what most ground cells of a block and of its neighbours say
  // tells true ground from reflections below it, which must not pull the envelope down.
  // Odd, and one of them around the vehicle's cell, so that no direction is special.
  static constexpr int kBlockCells = 9;
  static constexpr std::size_t kMinBlockCandidates = 3;

  [[nodiscard]] std::size_t block(int column, int row) const {
    return static_cast<std::size_t>(row * blocks_ + column);
  }

  /// The cell of a row where the candidates' box begins.
  [[nodiscard]] std::ptrdiff_t first_in_row(int row) const {
    return static_cast<std::ptrdiff_t>(row) * size_ + box_.left;
  }

  TileRunner* runner_;
  int size_;
  int blocks_;                          ///< A side, and one more at each end that stays empty.
  int before_first_;                    ///< Cells by which the first block begins before the map.
  std::vector<BlockPlace> places_;      ///< Per column (and row, the same).
  std::vector<std::int32_t> envelope_;  ///< Per cell of the box, steps of 0.1 mm.
  Box box_;
  std::vector<Candidate> candidates_;
  std::vector<std::uint32_t> block_begin_;
  std::vector<float> block_heights_;
  std::vector<float> block_median_;
  // The height of the ground some metres around each block, metres above the vehicle's plane, and
  // 1; both 0 where nothing is known of it. Of the blocks around this scan's candidates: those of
  // others are of earlier scans.
  std::vector<float> reference_;
  std::vector<float> reference_weight_;
};

}  // namespace groundgrid
