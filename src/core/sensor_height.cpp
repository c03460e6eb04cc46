// Estimate of the sensor's height above the ground where no mounting is given.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/point_transform.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid {
namespace {

// Flat cells within reach of the vehicle vote with their lowest point; the height with the most
// votes is the ground's. Cells, not points, vote: a roof hit by many beams counts no more than
// the road it stands on, and the road covers more cells.
constexpr float kCell_m = 0.5F;
constexpr float kReach_m = 20.0F;
constexpr int kCells = 80;
constexpr float kFlat_m = 0.12F;
constexpr float kMaxHeight_m = 8.0F;
constexpr float kBin_m = 0.05F;
constexpr int kBins = 160;
constexpr int kMinVotes = 5;

struct Extremes {
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
};

std::vector<Extremes> cell_extremes(const PointView& points) {
  std::vector<Extremes> cells(static_cast<std::size_t>(kCells) * kCells);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Point3f p = load_point(points, i);
    const bool near = std::abs(p.x) < kReach_m && std::abs(p.y) < kReach_m && std::isfinite(p.z);
    if (!near) continue;
    const int column = std::min(static_cast<int>((p.x + kReach_m) / kCell_m), kCells - 1);
    const int row = std::min(static_cast<int>((p.y + kReach_m) / kCell_m), kCells - 1);
    Extremes& cell = cells[static_cast<std::size_t>(row * kCells + column)];
    cell.min = std::min(cell.min, p.z);
    cell.max = std::max(cell.max, p.z);
  }
  return cells;
}

/// Depths below the sensor of all flat cells, ascending.
std::vector<float> flat_depths(const PointView& points) {
  std::vector<float> depths;
  for (const Extremes& cell : cell_extremes(points)) {
    const float depth = -cell.min;
    if (cell.max - cell.min < kFlat_m && depth > 0.0F && depth < kMaxHeight_m)
      depths.push_back(depth);
  }
  std::sort(depths.begin(), depths.end());
  return depths;
}

int most_voted_bin(const std::vector<float>& depths) {
  std::vector<int> votes(kBins + 2);
  for (const float depth : depths)
    ++votes[static_cast<std::size_t>(std::min(static_cast<int>(depth / kBin_m), kBins - 1)) + 1];
  int best = 0;
  int best_votes = 0;
  for (int bin = 0; bin < kBins; ++bin) {
    const auto i = static_cast<std::size_t>(bin);
    const int around = votes[i] + votes[i + 1] + votes[i + 2];
    if (around > best_votes) {
      best = bin;
      best_votes = around;
    }
  }
  return best;
}

}  // namespace

std::optional<double> estimate_sensor_height(const PointView& points) {
  const std::vector<float> depths = flat_depths(points);
  if (depths.size() < kMinVotes) return std::nullopt;
  const auto bin = static_cast<float>(most_voted_bin(depths));
  const auto begin = std::lower_bound(depths.begin(), depths.end(), (bin - 1.0F) * kBin_m);
  const auto end = std::lower_bound(depths.begin(), depths.end(), (bin + 2.0F) * kBin_m);
  if (end - begin < kMinVotes) return std::nullopt;
  return static_cast<double>(*(begin + (end - begin) / 2));
}

}  // namespace groundgrid
