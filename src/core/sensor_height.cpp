// Estimate of the sensor's height above the ground where no mounting is given.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/exclusion.hpp"
#include "core/input_checks.hpp"
#include "core/stages/rasterization.hpp"
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
constexpr double kFlat_m = 0.12;
constexpr double kMaxSensorHeight_m = 8.0;
constexpr double kBin_m = 0.05;
constexpr int kBins = 160;
constexpr std::size_t kMinVotes = 5;
// The plane starts from cells this close to the vote and ends with cells this close to itself.
constexpr double kFirstInlier_m = 0.3;
constexpr double kLastInlier_m = 0.1;
constexpr int kFits = 4;
constexpr double kPerMetre = 100.0;  // The estimate is in whole centimetres.

struct FlatCell {
  double x = 0.0;
  double y = 0.0;
  double depth = 0.0;  ///< Below the sensor, metres.
};

/// Cells around the sensor, row by row.
std::vector<CellStatistics> cells_around(const PointView& points, const Exclusion& exclusion) {
  constexpr std::size_t kPointsAtOnce = 4096;
  const WindowCells window(kCells, kCell_m);
  ScanGrid grid(static_cast<std::size_t>(kCells) * kCells);
  const CellBand all{0, static_cast<std::uint32_t>(grid.statistics.size())};
  SensorPass pass;
  pass.trajectory.set_fixed(Eigen::Isometry3d(
      Eigen::Translation3d(static_cast<double>(kReach_m), static_cast<double>(kReach_m), 0.0)));
  BinnedPoints bins;
  bins.resize(kPointsAtOnce);
  for (std::size_t first = 0; first < points.count; first += kPointsAtOnce) {
    pass.points = points;
    pass.points.data += first * points.stride_bytes;
    const std::size_t count = std::min(kPointsAtOnce, points.count - first);
    bin_points(pass, {0, count}, window, exclusion, bins);
    add_to_cells(bins, {0, count}, all, grid);
  }
  return std::move(grid.statistics);
}

double centre_of(int cell) {
  return (cell + 0.5) * static_cast<double>(kCell_m) - static_cast<double>(kReach_m);
}

std::vector<FlatCell> flat_cells(const PointView& points, const Exclusion& exclusion) {
  const std::vector<CellStatistics> cells = cells_around(points, exclusion);
  std::vector<FlatCell> flat;
  for (int row = 0; row < kCells; ++row) {
    for (int column = 0; column < kCells; ++column) {
      const CellStatistics& cell = cells[static_cast<std::size_t>(row * kCells + column)];
      if (cell.count == 0 || (cell.max - cell.min) * CellStatistics::kStep_m >= kFlat_m) continue;
      const double depth = -0.5 * (cell.min + cell.max) * CellStatistics::kStep_m;
      if (depth > 0.0 && depth < kMaxSensorHeight_m)
        flat.push_back({centre_of(column), centre_of(row), depth});
    }
  }
  return flat;
}

/// The depth around which most cells lie.
double most_voted_depth(const std::vector<FlatCell>& cells) {
  std::vector<int> votes(kBins + 2);
  for (const FlatCell& cell : cells) {
    const int bin = static_cast<int>(cell.depth / kBin_m);
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
  return (best + 0.5) * kBin_m;
}

/// Depth, rise along x, rise along y of the plane through the cells close to `plane`.
std::optional<Eigen::Vector3d> fit_plane(const std::vector<FlatCell>& cells,
                                         const Eigen::Vector3d& plane, double inlier_m) {
  // Sums one by one and without a jump: most of what an estimate costs once the cells are known.
  double n = 0.0, x = 0.0, y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0, d = 0.0, dx = 0.0, dy = 0.0;
  for (const FlatCell& cell : cells) {
    const double off = cell.depth - (plane[0] + plane[1] * cell.x + plane[2] * cell.y);
    const double taken = std::abs(off) > inlier_m ? 0.0 : 1.0;
    const double taken_x = taken * cell.x;
    const double taken_y = taken * cell.y;
    n += taken;
    x += taken_x;
    y += taken_y;
    xx += taken_x * cell.x;
    xy += taken_x * cell.y;
    yy += taken_y * cell.y;
    d += taken * cell.depth;
    dx += taken_x * cell.depth;
    dy += taken_y * cell.depth;
  }
  if (n < static_cast<double>(kMinVotes)) return std::nullopt;
  Eigen::Matrix3d normal;
  normal << n, x, y, x, xx, xy, y, xy, yy;
  const Eigen::Vector3d right(d, dx, dy);
  // A touch of weight on "level" keeps the plane defined where all cells lie in one line.
  normal.diagonal().tail<2>().array() += 1.0;
  return Eigen::Vector3d(normal.ldlt().solve(right));
}

}  // namespace

std::optional<double> estimate_sensor_height(const PointView& points, const Config& config) {
  check_view(points);
  const std::vector<FlatCell> cells = flat_cells(points, Exclusion(config.vehicle));
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
  if (!(height > 0.0 && height < kMaxSensorHeight_m)) return std::nullopt;
  // A return more or less then hardly ever changes it, and with it the whole map.
  return std::round(height * kPerMetre) / kPerMetre;
}

}  // namespace groundgrid
