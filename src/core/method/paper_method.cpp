// GroundGrid as the paper has it: section III in its order, a function for each subsection. This is
// what Config::paper() runs. Equations: equations.hpp. How it reads what the paper leaves open:
// docs/method.md.
#include "core/method/paper_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/method/equations.hpp"
#include "core/method/line_of_sight.hpp"
#include "core/method/spiral.hpp"

namespace groundgrid::paper {

/// III-A: "If the intersection shows that there is no line of sight between the sensor and the
/// point, the point is classified as an outlier."
void filter_outliers(const Scan& scan, const Config& config, const ElevationMap& map,
                     BinnedPoints& bins) {
  if (map.blank()) return;
  const RayRule rule{config.paper_only.outlier_tolerance_m,
                     config.paper_only.outlier_min_confidence};
  for (const SensorPass& sensor : scan.sensors) {
    for (std::size_t i = 0; i < sensor.points.count; ++i) {
      std::uint32_t& cell = bins.cell[sensor.first + i];
      if (cell == BinnedPoints::kNoCell) continue;
      const PointTransform T_window_sensor = sensor.trajectory.at(sensor.points, i);
      const Point3f point = T_window_sensor.apply(load_point(sensor.points, i));
      if (!has_line_of_sight(map, T_window_sensor.origin(), point, rule))
        cell |= BinnedPoints::kOutlier;
    }
  }
}

/// III-B: "first of all the variance layer", then "the minimal, maximal, and average values of the
/// z-coordinate (height) as well as the point count for each cell." Sums of whole numbers in place
/// of Welford's algorithm: the same for any order of the points.
void rasterize(const BinnedPoints& bins, ScanGrid& grid) {
  clear(grid);
  for (std::size_t i = 0; i < bins.cell.size(); ++i) {
    const std::uint32_t cell = bins.cell[i];
    if (cell >= BinnedPoints::kOutlier) continue;
    add_point(bins.z[i], grid.statistics[cell]);
    grid.is_occupied[cell] = 1;
  }
  list_occupied(grid);
}

namespace {

/// Sums over the cells of a patch.
struct Patch {
  float points = 0.0F;           ///< ΣP
  float points_lowest = 0.0F;    ///< Σ(P ∘ M)
  float points_variance = 0.0F;  ///< Variances, weighted by points.
};

/// "patches of 9 (3 × 3) to 25 (5 × 5) cells depending on the distance to the sensor"
Patch sum_patch(const ScanGrid& grid, int size, int column, int row, double distance,
                const Config& config) {
  const int half = distance < config.paper_only.patch_change_distance_m ? 1 : 2;
  Patch patch;
  for (int y = std::max(row - half, 0); y <= std::min(row + half, size - 1); ++y) {
    for (int x = std::max(column - half, 0); x <= std::min(column + half, size - 1); ++x) {
      const CellStatistics& cell = grid.statistics[static_cast<std::size_t>(y * size + x)];
      if (cell.count == 0) continue;
      const auto points = static_cast<float>(cell.count);
      patch.points += points;
      patch.points_lowest += points * lowest_m(cell);
      patch.points_variance += points * static_cast<float>(cell.variance_m2());
    }
  }
  return patch;
}

/// Planar, from the nearest sensor to the middle of a cell.
double distance_to_sensor(const Scan& scan, double cell_size, int column, int row) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Point3f& sensor : scan.positions)
    nearest =
        std::min(nearest, std::hypot((column + 0.5) * cell_size - static_cast<double>(sensor.x),
                                     (row + 0.5) * cell_size - static_cast<double>(sensor.y)));
  return nearest;
}

enum class CellClass { skipped, obstacle, ground };

/// III-C: "Cells that contain less than a predefined fraction of the expected points are skipped."
/// "If a cell does not contain enough points to calculate the variance, the average variance value
/// of the patch is used. A cell in the center of a patch is classified as ground if the variance of
/// the cell is below the variance threshold t_v."
CellClass classify_cell(const CellStatistics& cell, const Patch& patch, double distance,
                        const Config& config) {
  if (cell.count < config.paper_only.min_point_fraction * expected_points(distance, config))
    return CellClass::skipped;
  const bool enough =
      cell.count >= static_cast<std::uint32_t>(config.paper_only.own_variance_min_points);
  const double variance =
      enough ? cell.variance_m2() : static_cast<double>(patch.points_variance / patch.points);
  return variance < variance_threshold(distance, config) ? CellClass::ground : CellClass::obstacle;
}

/// III-D: "Considering only ground cells, the elevation and confidence values are integrated with
/// the existing values from previous observations". "We also calculate 3 for non-ground cells".
CellEstimate calculate_elevation(CellClass cell, const Patch& patch, const CellEstimate& known,
                                 const Config& config) {
  const float h = ground_elevation(patch.points_lowest, patch.points);
  if (cell == CellClass::obstacle) return lowered_by_obstacle(known, h);
  const float q = observation_confidence(patch.points, config);
  return {fused_height(known, h, q), fused_confidence(known.confidence, q)};
}

}  // namespace

/// III-C and III-D, cell by cell.
void observe_ground(const Scan& scan, const ScanGrid& grid, const Config& config,
                    GroundMask& is_ground, ElevationMap& map) {
  std::fill(is_ground.begin(), is_ground.end(), std::uint8_t{0});
  const int size = map.size();
  for (const std::uint32_t i : grid.occupied) {
    const int row = static_cast<int>(i) / size;
    const int column = static_cast<int>(i) % size;
    const double distance = distance_to_sensor(scan, map.cell_size(), column, row);
    const Patch patch = sum_patch(grid, size, column, row, distance, config);
    const CellClass cell = classify_cell(grid.statistics[i], patch, distance, config);
    if (cell == CellClass::skipped) continue;
    is_ground[i] = cell == CellClass::ground ? 1 : 0;
    const CellEstimate known{map.height()[i], map.confidence()[i]};
    const CellEstimate updated = calculate_elevation(cell, patch, known, config);
    map.height()[i] = updated.height;
    map.confidence()[i] = updated.confidence;
  }
}

/// III-E: "The ground elevation is interpolated for cells where no ground points were detected. The
/// interpolation is performed spirally from the sensor origin." Each cell sees what those before it
/// have become.
void interpolate_terrain(const Scan& scan, const GroundMask& is_ground, const Config& config,
                         ElevationMap& map) {
  const int size = map.size();
  const auto theta = static_cast<float>(config.map.confidence_decay);
  float* heights = map.height().data();
  float* confidences = map.confidence().data();
  const auto interpolate = [&](int column, int row) {
    const auto cell = static_cast<std::size_t>(row * size + column);
    if (is_ground[cell] != 0) return;
    float sum_confidence = 0.0F;
    float sum_weighted = 0.0F;
    for (int y = std::max(row - 1, 0); y <= std::min(row + 1, size - 1); ++y) {
      for (int x = std::max(column - 1, 0); x <= std::min(column + 1, size - 1); ++x) {
        const auto near = static_cast<std::size_t>(y * size + x);
        sum_confidence += confidences[near];
        sum_weighted += confidences[near] * heights[near];
      }
    }
    const CellEstimate known{heights[cell], confidences[cell]};
    heights[cell] = interpolated_height(known, sum_confidence, sum_weighted);
    confidences[cell] = decayed_confidence(known.confidence, theta);
  };
  const bool no_sensor = scan.positions.empty();
  spiral(size, no_sensor ? size / 2 : map.nearest_cell(scan.positions.front().x),
         no_sensor ? size / 2 : map.nearest_cell(scan.positions.front().y), interpolate);
}

/// III-F: "We compare two threshold parameters h_g and h_o with each point's z-height above the
/// corresponding cell's elevation": h_g in ground cells, h_o in all others.
LabelCounts segment(const BinnedPoints& bins, const GroundMask& is_ground, const ElevationMap& map,
                    const Config& config, const Answers& answers) {
  LabelCounts counts;
  for (std::size_t i = 0; i < bins.cell.size(); ++i) {
    if (bins.cell[i] == BinnedPoints::kNoCell) {
      give(i, Label::unknown, std::numeric_limits<float>::quiet_NaN(), answers, counts);
      continue;
    }
    const std::uint32_t cell = bins.cell[i] & ~BinnedPoints::kOutlier;
    const float height =
        static_cast<float>(bins.z[i]) / BinnedPoints::kStepsPerMetre - map.height()[cell];
    const double threshold = is_ground[cell] != 0 ? config.labels.ground_threshold_m
                                                  : config.paper_only.obstacle_threshold_m;
    const bool low = static_cast<double>(height) <= threshold;
    const Label by_height = low ? Label::ground : Label::obstacle;
    give(i, bins.is_outlier(i) ? Label::outlier : by_height, height, answers, counts);
  }
  return counts;
}

LabelCounts process(const Scan& scan, const Config& config, BinnedPoints& bins, ScanGrid& grid,
                    GroundMask& is_ground, ElevationMap& map, const Answers& answers) {
  bin_points(scan.sensors, map, config, bins);
  filter_outliers(scan, config, map, bins);
  rasterize(bins, grid);
  observe_ground(scan, grid, config, is_ground, map);
  interpolate_terrain(scan, is_ground, config, map);
  map.mark_observed();
  return segment(bins, is_ground, map, config, answers);
}

}  // namespace groundgrid::paper
