#include "core/ground_envelope.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace groundgrid {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

template <typename Iterator>
float median(Iterator begin, Iterator end) {
  const Iterator middle = begin + (end - begin) / 2;
  std::nth_element(begin, middle, end);
  return *middle;
}

/// Lets the heights of a row rise from the row beside it.
void spread_across(const float* from, float* row, int size, float rise) {
  const float diagonal = rise * std::numbers::sqrt2_v<float>;
  row[0] = std::min({row[0], from[0] + rise, from[1] + diagonal});
  for (int x = 1; x < size - 1; ++x) {
    const float beside = std::min(from[x - 1], from[x + 1]) + diagonal;
    row[x] = std::min({row[x], from[x] + rise, beside});
  }
  row[size - 1] = std::min({row[size - 1], from[size - 1] + rise, from[size - 2] + diagonal});
}

}  // namespace

GroundEnvelope::GroundEnvelope(const ElevationMap& map)
    : size_(map.size()),
      blocks_(2 * ((map.size() / 2 + kBlockCells / 2) / kBlockCells) + 1),
      before_first_((blocks_ * kBlockCells - map.size()) / 2),
      envelope_(map.cells()) {
  const auto blocks = static_cast<std::size_t>(blocks_) * static_cast<std::size_t>(blocks_);
  candidates_.reserve(map.cells());
  block_heights_.reserve(map.cells());
  block_begin_.resize(blocks + 2);
  block_median_.resize(blocks);
  block_reference_.resize(blocks);
}

void GroundEnvelope::list_candidates(const ScanGrid& grid, const ElevationMap& map,
                                     const Plane& vehicle_plane, const GroundCells& ground_cells) {
  const auto rise_x = static_cast<float>(vehicle_plane.slope_x * map.cell_size());
  const auto rise_y = static_cast<float>(vehicle_plane.slope_y * map.cell_size());
  const int middle_cell = size_ / 2;
  const auto middle = static_cast<float>(middle_cell);
  candidates_.clear();
  for (std::size_t i = 0; i < grid.occupied.size(); ++i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (!seen.ground) continue;
    const std::uint32_t cell = grid.occupied[i];
    const int row = static_cast<int>(cell) / size_;
    const int column = static_cast<int>(cell) % size_;
    const float plane = rise_x * (static_cast<float>(column) - middle) +
                        rise_y * (static_cast<float>(row) - middle);
    const int block = block_of(row) * blocks_ + block_of(column);
    candidates_.push_back({static_cast<std::uint32_t>(i), cell, static_cast<std::uint32_t>(block),
                           seen.patch_elevation - plane});
  }
}

void GroundEnvelope::find_block_medians() {
  // A counting sort by block: block b ends up in [begin[b], begin[b + 1]).
  std::fill(block_begin_.begin(), block_begin_.end(), 0U);
  for (const Candidate& candidate : candidates_) ++block_begin_[candidate.block + 2];
  for (std::size_t b = 2; b < block_begin_.size(); ++b) block_begin_[b] += block_begin_[b - 1];
  block_heights_.resize(candidates_.size());
  for (const Candidate& candidate : candidates_)
    block_heights_[block_begin_[candidate.block + 1]++] = candidate.height;
  for (std::size_t b = 0; b < block_median_.size(); ++b) {
    const auto begin = block_heights_.begin() + block_begin_[b];
    const auto end = block_heights_.begin() + block_begin_[b + 1];
    const bool enough = static_cast<std::size_t>(end - begin) >= kMinBlockCandidates;
    block_median_[b] = enough ? median(begin, end) : kNone;
  }
}

float GroundEnvelope::median_around(int block_column, int block_row) const {
  std::array<float, 9> medians{};
  std::size_t count = 0;
  for (int y = std::max(block_row - 1, 0); y <= std::min(block_row + 1, blocks_ - 1); ++y) {
    for (int x = std::max(block_column - 1, 0); x <= std::min(block_column + 1, blocks_ - 1); ++x) {
      const float value = block_median_[static_cast<std::size_t>(y * blocks_ + x)];
      if (!std::isnan(value)) medians[count++] = value;
    }
  }
  return count == 0 ? kNone : median(medians.begin(), medians.begin() + count);
}

void GroundEnvelope::find_references() {
  find_block_medians();
  for (int row = 0; row < blocks_; ++row)
    for (int column = 0; column < blocks_; ++column)
      block_reference_[static_cast<std::size_t>(row * blocks_ + column)] =
          median_around(column, row);
}

/// The references of the four blocks around a cell, bilinear between the blocks' middles; those
/// that have none are left out.
float GroundEnvelope::trend(std::uint32_t cell) const {
  const auto in_blocks = [this](int cells) {
    return (static_cast<float>(cells + before_first_) + 0.5F) / static_cast<float>(kBlockCells) -
           0.5F;
  };
  const float x = in_blocks(static_cast<int>(cell) % size_);
  const float y = in_blocks(static_cast<int>(cell) / size_);
  const int left = static_cast<int>(std::floor(x));
  const int bottom = static_cast<int>(std::floor(y));
  float sum = 0.0F;
  float weights = 0.0F;
  for (int row = std::max(bottom, 0); row <= std::min(bottom + 1, blocks_ - 1); ++row) {
    for (int column = std::max(left, 0); column <= std::min(left + 1, blocks_ - 1); ++column) {
      const float reference = block_reference_[static_cast<std::size_t>(row * blocks_ + column)];
      const float weight = (1.0F - std::abs(x - static_cast<float>(column))) *
                           (1.0F - std::abs(y - static_cast<float>(row)));
      if (std::isnan(reference)) continue;
      sum += weight * reference;
      weights += weight;
    }
  }
  return weights > 0.0F ? sum / weights : 0.0F;
}

void GroundEnvelope::spread(float rise) {
  // The two sweeps of a chamfer distance transform (Borgefors) carry every height to all cells.
  const auto row_of = [this](int row) {
    return envelope_.data() + static_cast<std::ptrdiff_t>(row) * size_;
  };
  for (int row = 0; row < size_; ++row) {
    float* here = row_of(row);
    if (row > 0) spread_across(row_of(row - 1), here, size_, rise);
    for (int x = 1; x < size_; ++x) here[x] = std::min(here[x], here[x - 1] + rise);
  }
  for (int row = size_ - 1; row >= 0; --row) {
    float* here = row_of(row);
    if (row < size_ - 1) spread_across(row_of(row + 1), here, size_, rise);
    for (int x = size_ - 2; x >= 0; --x) here[x] = std::min(here[x], here[x + 1] + rise);
  }
}

void GroundEnvelope::reject_raised(const ScanGrid& grid, const ElevationMap& map,
                                   const Plane& vehicle_plane, const Config& config,
                                   GroundCells& ground_cells) {
  list_candidates(grid, map, vehicle_plane, ground_cells);
  find_references();
  std::fill(envelope_.begin(), envelope_.end(), std::numeric_limits<float>::infinity());
  const auto pit = static_cast<float>(config.envelope_pit_m);
  for (Candidate& candidate : candidates_) {
    const bool is_pit = candidate.height < block_reference_[candidate.block] - pit;
    candidate.height -= trend(candidate.cell);
    if (!is_pit) envelope_[candidate.cell] = candidate.height;
  }
  spread(static_cast<float>(config.envelope_slope * map.cell_size()));
  const auto step = static_cast<float>(config.envelope_step_m);
  for (const Candidate& candidate : candidates_)
    if (candidate.height > envelope_[candidate.cell] + step)
      ground_cells.withdraw(candidate.index, candidate.cell);
}

}  // namespace groundgrid
