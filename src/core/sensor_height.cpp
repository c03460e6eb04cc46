// Estimate of the sensor's height above the ground where no mounting is given.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/exclusion.hpp"
#include "core/input_checks.hpp"
#include "core/point_transform.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid {
namespace {

// Flat cells within reach of the vehicle vote with their height; the height with the most votes
// is the ground's, roughly, and a plane through the cells that agree with it gives the height
// under the sensor. Cells, not points, vote: a roof hit by many beams counts no more than the road
// it stands on, and the road covers more cells.
constexpr float kCell_m = 0.5F;
constexpr float kReach_m = 20.0F;
constexpr int kCells = 80;
constexpr float kFlat_m = 0.12F;
constexpr float kMaxSensorHeight_m = 8.0F;
constexpr float kBin_m = 0.05F;
constexpr int kBins = 160;
constexpr std::size_t kMinVotes = 5;
// The plane starts from cells this close to the vote and ends with cells this close to itself.
constexpr double kFirstInlier_m = 0.3;
constexpr double kLastInlier_m = 0.1;
constexpr int kFits = 4;

struct Extremes {
  float min = std::numeric_limits<float>::infinity();
  float max = -std::numeric_limits<float>::infinity();
};

struct FlatCell {
  double x = 0.0;
  double y = 0.0;
  double depth = 0.0;  ///< Below the sensor, metres.
};

std::vector<Extremes> cell_extremes(const PointView& points, const Exclusion& exclusion) {
  std::vector<Extremes> cells(static_cast<std::size_t>(kCells) * kCells);
  for (std::size_t i = 0; i < points.count; ++i) {
    const Point3f p = load_point(points, i);
    const bool near = std::abs(p.x) < kReach_m && std::abs(p.y) < kReach_m && std::isfinite(p.z);
    if (!near || exclusion.takes(p, PointTransform{})) continue;
    const int column = std::min(static_cast<int>((p.x + kReach_m) / kCell_m), kCells - 1);
    const int row = std::min(static_cast<int>((p.y + kReach_m) / kCell_m), kCells - 1);
    Extremes& cell = cells[static_cast<std::size_t>(row * kCells + column)];
    cell.min = std::min(cell.min, p.z);
    cell.max = std::max(cell.max, p.z);
  }
  return cells;
}

double centre_of(int cell) {
  return (cell + 0.5) * static_cast<double>(kCell_m) - static_cast<double>(kReach_m);
}

std::vector<FlatCell> flat_cells(const PointView& points, const Exclusion& exclusion) {
  const std::vector<Extremes> cells = cell_extremes(points, exclusion);
  std::vector<FlatCell> flat;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const Extremes& cell = cells[static_cast<std::size_t>(row * kCells + column)];
      const float depth = -0.5F * (cell.min + cell.max);
      if (cell.max - cell.min < kFlat_m && depth > 0.0F && depth < kMaxSensorHeight_m)
        flat.push_back({centre_of(column), centre_of(row), static_cast<double>(depth)});
    }
  }
  return flat;
}

/// The depth around which most cells lie.
double most_voted_depth(const std::vector<FlatCell>& cells) {
  std::vector<int> votes(kBins + 2);
  for (const FlatCell& cell : cells) {
    const int bin = static_cast<int>(cell.depth / static_cast<double>(kBin_m));
    ++votes[static_cast<std::size_t>(std::min(bin, kBins - 1)) + 1];
  }
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
  return (best + 0.5) * static_cast<double>(kBin_m);
}

/// Depth, rise along x, rise along y of the plane through the cells close to `plane`.
std::optional<Eigen::Vector3d> fit_plane(const std::vector<FlatCell>& cells,
                                         const Eigen::Vector3d& plane, double inlier_m) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  std::size_t inliers = 0;
  for (const FlatCell& cell : cells) {
    const Eigen::Vector3d row(1.0, cell.x, cell.y);
    if (std::abs(cell.depth - row.dot(plane)) > inlier_m) continue;
    normal += row * row.transpose();
    right += row * cell.depth;
    ++inliers;
  }
  if (inliers < kMinVotes) return std::nullopt;
  // A touch of weight on "level" keeps the plane defined where all cells lie in one line.
  normal.diagonal().tail<2>().array() += 1.0;
  return Eigen::Vector3d(normal.ldlt().solve(right));
}

}  // namespace

std::optional<double> estimate_sensor_height(const PointView& points, const Config& config) {
  check_view(points);
  const std::vector<FlatCell> cells = flat_cells(points, Exclusion(config));
  if (cells.size() < kMinVotes) return std::nullopt;
  Eigen::Vector3d plane(most_voted_depth(cells), 0.0, 0.0);
  for (int fit = 0; fit < kFits; ++fit) {
    const double share = static_cast<double>(fit) / (kFits - 1);
    const double inlier = kFirstInlier_m + share * (kLastInlier_m - kFirstInlier_m);
    const std::optional<Eigen::Vector3d> fitted = fit_plane(cells, plane, inlier);
    if (!fitted) return std::nullopt;
    plane = *fitted;
  }
  // The plane may meet the sensor's axis where no cell was, even above the sensor.
  const double height = plane.x();
  if (!(height > 0.0 && height < static_cast<double>(kMaxSensorHeight_m))) return std::nullopt;
  return height;
}

}  // namespace groundgrid
