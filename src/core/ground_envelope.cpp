#include "core/ground_envelope.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>

#include "core/envelope_kernels.hpp"
#include "core/window_cells.hpp"

namespace groundgrid {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();
constexpr std::size_t kCandidatesPerTile = 4096;
constexpr std::size_t kBlocksPerTile = 512;

/// To steps of 0.1 mm, in which the sweeps come to the same on every machine; no height is beyond
/// a kilometre.
std::int32_t in_steps(float metres) {
  return static_cast<std::int32_t>(std::lrint(std::clamp(metres, -1e3F, 1e3F) * 1e4F));
}

}  // namespace

GroundEnvelope::GroundEnvelope(const ElevationMap& map, TileRunner& runner)
    : runner_(&runner),
      size_(map.size()),
      blocks_(2 * ((map.size() / 2 + kBlockCells / 2) / kBlockCells) + 3),
      before_first_((blocks_ * kBlockCells - map.size()) / 2),
      envelope_(map.cells()) {
  for (int cell = 0; cell < size_; ++cell) places_.push_back(place_of(cell));
  const std::size_t blocks = block(0, blocks_);
  candidates_.reserve(map.cells());
  block_heights_.reserve(map.cells() + kRankSpare);
  block_begin_.resize(blocks + 2);
  block_median_.resize(blocks);
  reference_.resize(blocks);
  reference_weight_.resize(blocks);
}

GroundEnvelope::BlockPlace GroundEnvelope::place_of(int column_or_row) const {
  const int cells = column_or_row + before_first_;
  const float in_blocks =
      (static_cast<float>(cells) + 0.5F) / static_cast<float>(kBlockCells) - 0.5F;
  const float before = std::floor(in_blocks);
  return {cells / kBlockCells, static_cast<int>(before), in_blocks - before};
}

void GroundEnvelope::list_candidates(const ScanGrid& grid, const ElevationMap& map,
                                     const Plane& vehicle_plane, const GroundCells& ground_cells) {
  const auto rise_x = static_cast<float>(vehicle_plane.slope_x * map.cell_size());
  const auto rise_y = static_cast<float>(vehicle_plane.slope_y * map.cell_size());
  const int middle = size_ / 2;
  candidates_.clear();
  AscendingRows rows(static_cast<std::size_t>(size_));
  for (std::size_t i = 0; i < grid.occupied.size(); ++i) {
    const GroundCell& seen = ground_cells.cells()[i];
    if (!seen.ground) continue;
    const auto row = static_cast<int>(rows.row_of(grid.occupied[i]));
    const int column = static_cast<int>(grid.occupied[i]) - row * size_;
    const float plane =
        rise_x * static_cast<float>(column - middle) + rise_y * static_cast<float>(row - middle);
    const std::size_t own = block(places_[static_cast<std::size_t>(column)].own,
                                  places_[static_cast<std::size_t>(row)].own);
    candidates_.push_back({static_cast<std::uint32_t>(i), grid.occupied[i],
                           static_cast<std::uint32_t>(own), static_cast<std::uint16_t>(column),
                           static_cast<std::uint16_t>(row), seen.patch_elevation - plane});
  }
}

void GroundEnvelope::find_block_medians() {
  // A counting sort by block: block b ends up in [begin[b], begin[b + 1]).
  std::fill(block_begin_.begin(), block_begin_.end(), 0U);
  for (const Candidate& candidate : candidates_) ++block_begin_[candidate.block + 2];
  for (std::size_t b = 2; b < block_begin_.size(); ++b) block_begin_[b] += block_begin_[b - 1];
  block_heights_.resize(candidates_.size() + kRankSpare);
  for (const Candidate& candidate : candidates_)
    block_heights_[block_begin_[candidate.block + 1]++] = candidate.height;
  const auto find_medians = [&](std::size_t begin, std::size_t end) {
    for (std::size_t b = begin; b < end; ++b) {
      const std::size_t count = block_begin_[b + 1] - block_begin_[b];
      block_median_[b] = count >= kMinBlockCandidates
                             ? ranked(block_heights_.data() + block_begin_[b], count, count / 2)
                             : kNone;
    }
  };
  runner_->parallel_for_ranges(block_median_.size(), kBlocksPerTile, find_medians);
}

/// The medians of the medians of a block and of those around it, of all blocks that candidates lie
/// in or between.
void GroundEnvelope::find_references() {
  find_block_medians();
  // The blocks at the ends stay without.
  const auto first = [this](int cells) {
    return std::max(places_[static_cast<std::size_t>(cells)].before, 1);
  };
  const auto last = [this](int cells) {
    return std::min(places_[static_cast<std::size_t>(cells)].before + 1, blocks_ - 2);
  };
  const int left = first(box_.left);
  const auto count = static_cast<std::size_t>(last(box_.right) + 1 - left);
  const auto medians_of = [&](int row) { return block_median_.data() + block(left - 1, row); };
  for (int row = first(box_.bottom); row <= last(box_.top); ++row)
    median_row({medians_of(row - 1), medians_of(row), medians_of(row + 1)}, count,
               reference_.data() + block(left, row), reference_weight_.data() + block(left, row));
}

/// The references of the four blocks around a cell, bilinear between the blocks' middles; those
/// that have none are left out.
float GroundEnvelope::trend(const Candidate& candidate) const {
  const BlockPlace& x = places_[candidate.column];
  const BlockPlace& y = places_[candidate.row];
  const std::size_t lower = block(x.before, y.before);
  const std::size_t upper = lower + static_cast<std::size_t>(blocks_);
  const auto mix = [](float before, float after, float share) {
    return before + share * (after - before);
  };
  const auto blend = [&](const std::vector<float>& of) {
    return mix(mix(of[lower], of[lower + 1], x.share_after),
               mix(of[upper], of[upper + 1], x.share_after), y.share_after);
  };
  const float weight = blend(reference_weight_);
  return weight > 0.0F ? blend(reference_) / weight : 0.0F;
}

void GroundEnvelope::spread(float rise) {
  // The two sweeps of a chamfer distance transform (Borgefors) carry every height to all cells.
  // The shortest way from one candidate to another leads through no cell outside of their box.
  const EnvelopeRise steps{in_steps(rise), in_steps(rise * std::numbers::sqrt2_v<float>)};
  const std::size_t count = box_.columns();
  const auto row_of = [&](int row) { return envelope_.data() + first_in_row(row); };
  for (int row = box_.bottom; row <= box_.top; ++row) {
    if (row > box_.bottom) spread_across(row_of(row - 1), row_of(row), count, steps);
    spread_forward(row_of(row), count, steps.straight);
  }
  for (int row = box_.top; row >= box_.bottom; --row) {
    if (row < box_.top) spread_across(row_of(row + 1), row_of(row), count, steps);
    spread_backward(row_of(row), count, steps.straight);
  }
}

/// Forgets the heights of the scan before wherever this one's candidates look.
void GroundEnvelope::clear_box() {
  box_ = {size_ - 1, 0, size_ - 1, 0};
  for (const Candidate& candidate : candidates_) {
    box_.left = std::min<int>(box_.left, candidate.column);
    box_.right = std::max<int>(box_.right, candidate.column);
  }
  box_.bottom = candidates_.front().row;
  box_.top = candidates_.back().row;
  for (int row = box_.bottom; row <= box_.top; ++row)
    std::fill_n(envelope_.data() + first_in_row(row), box_.columns(), kNoEnvelope);
}

/// Heights above the trend; those that are no pits, which are reflections, hold the envelope.
void GroundEnvelope::measure_from_trend(const Config& config) {
  const auto pit = static_cast<float>(config.envelope_pit_m);
  const auto measure = [&](std::size_t begin, std::size_t end) {
    for (Candidate& candidate : std::span(candidates_).subspan(begin, end - begin)) {
      const bool is_pit = reference_weight_[candidate.block] > 0.0F &&
                          candidate.height < reference_[candidate.block] - pit;
      candidate.steps = in_steps(candidate.height - trend(candidate));
      if (!is_pit) envelope_[candidate.cell] = candidate.steps;
    }
  };
  runner_->parallel_for_ranges(candidates_.size(), kCandidatesPerTile, measure);
}

void GroundEnvelope::reject_raised(const ScanGrid& grid, const ElevationMap& map,
                                   const Plane& vehicle_plane, const Config& config,
                                   GroundCells& ground_cells) {
  list_candidates(grid, map, vehicle_plane, ground_cells);
  if (candidates_.empty()) return;
  clear_box();
  find_references();
  measure_from_trend(config);
  spread(static_cast<float>(config.envelope_slope * map.cell_size()));
  const std::int32_t step = in_steps(static_cast<float>(config.envelope_step_m));
  const auto withdraw = [&](std::size_t begin, std::size_t end) {
    for (const Candidate& candidate : std::span(candidates_).subspan(begin, end - begin))
      if (candidate.steps > envelope_[candidate.cell] + step)
        ground_cells.withdraw(candidate.index, candidate.cell);
  };
  runner_->parallel_for_ranges(candidates_.size(), kCandidatesPerTile, withdraw);
}

}  // namespace groundgrid
