// The default method, plain. Where it is the paper's it says which section; the rest is ours, and
// docs/method.md says why. The fast stages give the same bits: where a sum is not in the order that
// comes to mind, it is in theirs.
#include "core/method/reference_method.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/kernels/surface_kernels.hpp"
#include "core/method/constants.hpp"
#include "core/method/equations.hpp"
#include "core/method/line_of_sight.hpp"
#include "core/method/paper_method.hpp"
#include "core/method/reference_surface.hpp"
#include "core/stages/cell_limits.hpp"
#include "core/stages/ground_cells.hpp"
#include "core/stages/map_check.hpp"
#include "core/stages/step_edges.hpp"

namespace groundgrid::reference {
namespace {

using namespace constants;

constexpr float kStep_m = static_cast<float>(CellStatistics::kStep_m);

/// Calls visit(cell, its distance in cells) for those at most `reach` away along each axis, the
/// cell itself left out.
template <typename Visit>
void for_each_around(const Window& window, std::uint32_t cell, int reach, const Visit& visit) {
  for (int y = -reach; y <= reach; ++y)
    for (int x = -reach; x <= reach; ++x)
      if ((x != 0 || y != 0) && window.contains(window.column(cell) + x, window.row(cell) + y))
        visit(window.cell(window.column(cell) + x, window.row(cell) + y), std::hypot(x, y));
}

// --- Outliers and statistics (III-A, III-B) ------------------------------------------------------

/// III-A, but only for points well below the map: a point at the map's height needs no ray.
void filter_deep_outliers(const Scan& scan, const ElevationMap& map, BinnedPoints& bins) {
  if (map.blank()) return;
  for (const SensorPass& sensor : scan.sensors) {
    for (std::size_t i = 0; i < sensor.points.count; ++i) {
      std::uint32_t& cell = bins.cell[sensor.first + i];
      if (cell == BinnedPoints::kNoCell) continue;
      const float z = static_cast<float>(bins.z[sensor.first + i]) * kStep_m;
      if (!(map.height()[cell] - z >= static_cast<float>(kReflectionDepth_m))) continue;
      const PointTransform T_window_sensor = sensor.trajectory.at(sensor.points, i);
      const Point3f point = T_window_sensor.apply(load_point(sensor.points, i));
      if (!has_line_of_sight(map, T_window_sensor.origin(), point,
                             {kRayTolerance_m, kRayConfidence}))
        cell |= BinnedPoints::kOutlier;
    }
  }
}

// --- Support -------------------------------------------------------------------------------------

/// 1 for each cell whose lowest return forms a surface with those of enough cells around it: cells
/// near each other belong to one surface if the slope between them is not too steep.
PerCell<std::uint8_t> find_supported(const ScanGrid& grid, const Window& window) {
  PerCell<std::uint8_t> supported(window.cells());
  PerCell<std::uint8_t> visited(window.cells());
  for (const std::uint32_t seed : grid.occupied) {
    if (visited[seed] != 0) continue;
    visited[seed] = 1;
    std::vector<std::uint32_t> surface{seed};
    for (std::size_t next = 0; next < surface.size(); ++next) {
      const std::uint32_t cell = surface[next];
      for_each_around(window, cell, kSupportReach, [&](std::uint32_t other, double apart) {
        if (grid.is_occupied[other] == 0 || visited[other] != 0) return;
        const std::int32_t rise = in_steps(kScatter_m + kSteepest * window.cell_size * apart);
        if (std::abs(grid.statistics[other].min - grid.statistics[cell].min) > rise) return;
        visited[other] = 1;
        surface.push_back(other);
      });
    }
    if (surface.size() < kSupportCells) continue;
    for (const std::uint32_t cell : surface) supported[cell] = 1;
  }
  return supported;
}

/// Marks the returns of unsupported cells that lie below a supported cell beside them; whether
/// there were any.
bool set_aside(const ScanGrid& grid, const PerCell<std::uint8_t>& supported, const Window& window,
               BinnedPoints& bins) {
  PerCell<std::int32_t> floor(window.cells(), std::numeric_limits<std::int32_t>::min());
  for (const std::uint32_t cell : grid.occupied) {
    if (supported[cell] != 0) continue;
    for_each_around(window, cell, kSupportReach, [&](std::uint32_t other, double apart) {
      if (supported[other] == 0) return;
      const double depth = kReflectionDepth_m + kSteepest * window.cell_size * apart;
      floor[cell] = std::max(floor[cell], grid.statistics[other].min - in_steps(depth));
    });
  }
  bool any = false;
  for (std::size_t i = 0; i < bins.cell.size(); ++i) {
    std::uint32_t& cell = bins.cell[i];
    if (cell >= BinnedPoints::kOutlier || bins.z[i] >= floor[cell]) continue;
    cell |= BinnedPoints::kOutlier;
    any = true;
  }
  return any;
}

/// What is left of a cell may be supported, support others, and show what lies below it.
PerCell<std::uint8_t> rasterize_supported(const Window& window, BinnedPoints& bins,
                                          ScanGrid& grid) {
  PerCell<std::uint8_t> supported = find_supported(grid, window);
  for (int pass = 0; pass < kSupportPasses && set_aside(grid, supported, window, bins); ++pass) {
    paper::rasterize(bins, grid);
    supported = find_supported(grid, window);
  }
  return supported;
}

// --- Ground cells (III-C) ------------------------------------------------------------------------

/// Sums over the cells of a patch: of points, of points · lowest and of points · variance.
struct Patch {
  float points = 0.0F;
  float lowest = 0.0F;
  float variance = 0.0F;

  friend Patch operator+(const Patch& a, const Patch& b) {
    return {a.points + b.points, a.lowest + b.lowest, a.variance + b.variance};
  }
};

/// Of the cells up to `half` away along each axis.
Patch sum_patch(const ScanGrid& grid, const Window& window, int column, int row, int half) {
  const auto column_sum = [&](int x) {
    Patch sum;
    for (int y = row - half; y <= row + half; ++y) {
      if (!window.contains(column + x, y)) continue;
      const CellStatistics& cell = grid.statistics[window.cell(column + x, y)];
      if (cell.count == 0) continue;
      const auto points = static_cast<float>(cell.count);
      sum = sum +
            Patch{points, points * lowest_m(cell), points * static_cast<float>(cell.variance_m2())};
    }
    return sum;
  };
  if (half == 1) return (column_sum(-1) + column_sum(0)) + column_sum(1);
  return ((column_sum(-2) + column_sum(0)) + (column_sum(-1) + column_sum(1))) + column_sum(2);
}

/// Planar, to the nearest sensor.
float distance_to_sensor(const Scan& scan, const Window& window, int column, int row) {
  const auto cell_size = static_cast<float>(window.cell_size);
  float nearest_squared = std::numeric_limits<float>::infinity();
  for (const Point3f& sensor : scan.positions) {
    const float x = (static_cast<float>(column) + 0.5F) * cell_size - sensor.x;
    const float y = (static_cast<float>(row) + 0.5F) * cell_size - sensor.y;
    nearest_squared = std::min(nearest_squared, x * x + y * y);
  }
  return std::sqrt(nearest_squared);
}

/// From the lowest returns of the cells beside a cell.
float slope_squared(const ScanGrid& grid, const Window& window, int column, int row) {
  const auto along = [&](int x, int y) {
    if (!window.contains(column - x, row - y) || !window.contains(column + x, row + y)) return 0.0F;
    const CellStatistics& before = grid.statistics[window.cell(column - x, row - y)];
    const CellStatistics& after = grid.statistics[window.cell(column + x, row + y)];
    if (before.count == 0 || after.count == 0) return 0.0F;
    return slope_along(lowest_m(before), lowest_m(grid.statistics[window.cell(column, row)]),
                       lowest_m(after), static_cast<float>(window.cell_size));
  };
  return along(1, 0) * along(1, 0) + along(0, 1) * along(0, 1);
}

/// III-C with one threshold at any distance, and any number of points; a slope is no roughness, and
/// only supported cells are ground.
GroundCell classify_cell(const Scan& scan, const ScanGrid& grid, const Window& window,
                         std::uint32_t index, bool supported) {
  const int column = window.column(index);
  const int row = window.row(index);
  const CellStatistics& cell = grid.statistics[index];
  const float distance = distance_to_sensor(scan, window, column, row);
  const Patch patch = sum_patch(grid, window, column, row, distance < kWidePatchFrom_m ? 1 : 2);
  const bool own = cell.count >= static_cast<std::uint32_t>(kOwnVariancePoints);
  const float variance =
      own ? static_cast<float>(cell.variance_m2()) : patch.variance / patch.points;
  const float threshold = variance_threshold_on(slope_squared(grid, window, column, row),
                                                static_cast<float>(window.cell_size));
  GroundCell result;
  result.patch_points = patch.points;
  result.patch_elevation = ground_elevation(patch.lowest, patch.points);
  result.variance = variance;
  result.observed = supported;
  result.ground = supported && variance < threshold;
  result.lone = !supported && variance < threshold;
  return result;
}

// --- The surface ---------------------------------------------------------------------------------

/// What is known of each cell: kUnknownHeight if nothing is.
PerCell<float> known_heights(const ScanGrid& grid, const std::vector<GroundCell>& cells,
                             const ElevationMap& map) {
  PerCell<float> heights(map.cells(), kUnknownHeight);
  for (std::size_t cell = 0; cell < map.cells(); ++cell)
    if (map.confidence()[cell] >= kRemembered) heights[cell] = map.height()[cell];
  for (std::size_t i = 0; i < cells.size(); ++i)
    if (cells[i].ground) heights[grid.occupied[i]] = cells[i].patch_elevation;
  return heights;
}

/// Less weight for cells that the surface does not go through.
float weight_of(float height, float surface) {
  const float off = height - surface;
  const float tolerance = off > 0.0F ? kSurfaceTolerance_m : kReflection_m;
  const float ratio = tolerance / std::max(std::abs(off), tolerance);
  return ratio * ratio;
}

/// The wide surface through the known cells, fitted again and again with less weight for those
/// above it.
Surface fit_surface(const Window& window, const PerCell<float>& heights, const LocalPlane& ground) {
  PerCell<float> weights(window.cells());
  for (std::size_t cell = 0; cell < window.cells(); ++cell)
    weights[cell] = heights[cell] == kUnknownHeight ? 0.0F : 1.0F;
  Surface surface(window, heights, weights, ground, kSurfaceBlock_m);
  for (int pass = 1; pass < kSurfacePasses; ++pass) {
    for (std::uint32_t cell = 0; cell < window.cells(); ++cell)
      if (heights[cell] != kUnknownHeight)
        weights[cell] = weight_of(heights[cell], surface.at(cell));
    surface = Surface(window, heights, weights, ground, kSurfaceBlock_m);
  }
  return surface;
}

/// 1 for each known cell that stands on the surface. A wide patch of them not far above it is
/// ground all the same: a terrace, a bank, a garden behind its wall.
PerCell<std::uint8_t> find_raised(const Window& window, const PerCell<float>& heights,
                                  const Surface& surface) {
  PerCell<std::uint8_t> raised(window.cells());
  for (std::uint32_t cell = 0; cell < window.cells(); ++cell)
    raised[cell] =
        heights[cell] != kUnknownHeight && heights[cell] > surface.at(cell) + kSurfaceStep_m ? 1
                                                                                             : 0;
  const auto wide =
      static_cast<std::size_t>(kTerraceArea_m2 / (window.cell_size * window.cell_size));
  PerCell<std::uint8_t> judged(window.cells());
  for (std::uint32_t seed = 0; seed < window.cells(); ++seed) {
    if (raised[seed] == 0 || judged[seed] != 0) continue;
    judged[seed] = 1;
    std::vector<std::uint32_t> patch{seed};
    float above = 0.0F;
    for (std::size_t next = 0; next < patch.size(); ++next) {
      const std::uint32_t cell = patch[next];
      above += heights[cell] - surface.at(cell);
      for_each_around(window, cell, kPatchReach, [&](std::uint32_t other, double apart) {
        if (raised[other] == 0 || judged[other] != 0) return;
        const float rise = kPatchStep_m + kPatchSlope * static_cast<float>(window.cell_size) *
                                              static_cast<float>(apart);
        if (std::abs(heights[other] - heights[cell]) > rise) return;
        judged[other] = 1;
        patch.push_back(other);
      });
    }
    const bool low = above < kTerraceHeight_m * static_cast<float>(patch.size());
    if (patch.size() > wide && low)
      for (const std::uint32_t cell : patch) raised[cell] = 0;
  }
  return raised;
}

/// Takes the class from what stands on the surface, gives it to lone cells that lie on it, and says
/// which cells hold the surface up: 1 for those.
PerCell<std::uint8_t> compare_with_surface(const ScanGrid& grid, const LocalPlane& ground,
                                           const Window& window, std::vector<GroundCell>& cells,
                                           ElevationMap& map) {
  const PerCell<float> heights = known_heights(grid, cells, map);
  const Surface surface = fit_surface(window, heights, ground);
  const PerCell<std::uint8_t> raised = find_raised(window, heights, surface);
  PerCell<std::uint8_t> on_surface(window.cells());
  for (std::size_t cell = 0; cell < window.cells(); ++cell) {
    on_surface[cell] = heights[cell] != kUnknownHeight && raised[cell] == 0 ? 1 : 0;
    if (raised[cell] != 0) map.confidence()[cell] = 0.0F;
  }
  for (std::size_t i = 0; i < cells.size(); ++i) {
    const std::uint32_t cell = grid.occupied[i];
    if (raised[cell] != 0) cells[i].ground = false;
    if (!cells[i].lone) continue;
    const float above = cells[i].patch_elevation - surface.at(cell);
    if (above > kSurfaceStep_m || above < -kReflection_m) continue;
    cells[i].ground = cells[i].observed = true;
    on_surface[cell] = 1;
  }
  return on_surface;
}

// --- Elevation and interpolation (III-D, III-E) --------------------------------------------------

/// III-D.
void update_elevation(const ScanGrid& grid, const std::vector<GroundCell>& cells,
                      const Config& config, ElevationMap& map) {
  for (std::size_t i = 0; i < cells.size(); ++i) {
    if (!cells[i].observed) continue;
    const std::uint32_t cell = grid.occupied[i];
    const CellEstimate known{map.height()[cell], map.confidence()[cell]};
    const float h = cells[i].patch_elevation;
    CellEstimate updated = lowered_by_obstacle(known, h);
    if (cells[i].ground) {
      const float q = observation_confidence(cells[i].patch_points, config);
      updated = {fused_height(known, h, q), fused_confidence(known.confidence, q)};
    }
    map.height()[cell] = updated.height;
    map.confidence()[cell] = updated.confidence;
  }
}

/// In place of III-E's spiral: cells that nothing is known of take the height of a fine surface
/// through those that are known, but none is above its lowest return. Confidence decays by eq. 8.
void fill(const ScanGrid& grid, const std::vector<GroundCell>& cells,
          const PerCell<std::uint8_t>& on_surface, const LocalPlane& ground, const Config& config,
          const Window& window, ElevationMap& map) {
  PerCell<std::uint8_t> is_ground(window.cells());
  for (std::size_t i = 0; i < cells.size(); ++i) is_ground[grid.occupied[i]] = cells[i].ground;
  const PerCell<float> weights(on_surface.begin(), on_surface.end());
  const Surface surface(window, map.height(), weights, ground, 0.0);
  const auto theta = static_cast<float>(config.map.confidence_decay);
  for (std::uint32_t cell = 0; cell < window.cells(); ++cell) {
    if (is_ground[cell] != 0) continue;
    map.confidence()[cell] = decayed_confidence(map.confidence()[cell], theta);
    if (on_surface[cell] != 0) continue;
    float& height = map.height()[cell];
    height = surface.at(cell);
    if (grid.is_occupied[cell] == 0) continue;
    const float lowest = lowest_m(grid.statistics[cell]);
    if (lowest < height + kFollow_m) height = lowest;
  }
}

// --- Labels (III-F) ------------------------------------------------------------------------------

/// Heights of a cell's points above the map, in steps.
struct Column {
  std::int64_t near_ground_sum = 0;
  std::int32_t near_ground = 0;  ///< Points near the ground.
  std::int32_t rising = 0;       ///< Points that rise from it.
};

PerCell<Column> count_columns(const BinnedPoints& bins, const ElevationMap& map) {
  const std::int32_t below = limited_steps(static_cast<float>(kReflectionDepth_m));
  const std::int32_t above = limited_steps(kLevelBand_m);
  const std::int32_t tall = limited_steps(kTall_m);
  const std::int32_t overhang = limited_steps(kOverhang_m);
  PerCell<Column> columns(map.cells());
  for (std::size_t i = 0; i < bins.cell.size(); ++i) {
    const std::uint32_t cell = bins.cell[i];
    if (cell >= BinnedPoints::kOutlier) continue;
    const std::int32_t up = bins.z[i] - limited_steps(map.height()[cell]);
    Column& column = columns[cell];
    if (up > -below && up < above) {
      ++column.near_ground;
      column.near_ground_sum += up;
    } else if (up > tall && up < overhang) {
      ++column.rising;
    }
  }
  return columns;
}

/// Level and threshold of each cell. In a column in which something rises the threshold is tight.
/// The map rests on minima: the level is the mean of the ground points around.
PerCell<CellLimit> choose_limits(const BinnedPoints& bins, const ScanGrid& grid,
                                 const ElevationMap& map, const Config& config,
                                 const Window& window) {
  const PerCell<Column> columns = count_columns(bins, map);
  const std::int32_t tall = limited_steps(kTall_m);
  PerCell<CellLimit> limits(window.cells());
  PerCell<float> weights(window.cells());
  PerCell<float> weighted(window.cells());
  for (const std::uint32_t cell : grid.occupied) {
    const Column& column = columns[cell];
    const bool rises =
        column.rising > 0 && static_cast<double>(column.rising) > kTallShare * column.near_ground;
    limits[cell].threshold =
        rises ? kTallThreshold_m : static_cast<float>(config.labels.ground_threshold_m);
    // Where something stands its feet would pass for ground: such cells take the level of others.
    const std::int64_t height = limited_steps(map.height()[cell]);
    if (grid.statistics[cell].max - height > tall) continue;
    const auto points = static_cast<float>(column.near_ground);
    const float share = 1.0F / (1.0F + points / kCellWeight);
    weights[cell] = share * points;
    weighted[cell] = share * static_cast<float>(column.near_ground_sum);
  }
  const auto around = [&](const PerCell<float>& of, std::uint32_t cell) {
    float sum = 0.0F;
    for (int x = -2; x <= 2; ++x) {
      float column = 0.0F;
      for (int y = -2; y <= 2; ++y)
        if (window.contains(window.column(cell) + x, window.row(cell) + y))
          column += of[window.cell(window.column(cell) + x, window.row(cell) + y)];
      sum += column;
    }
    return sum;
  };
  constexpr float kOwnMore = kOwnWeight - 1.0F;
  for (const std::uint32_t cell : grid.occupied) {
    const float steps = kOwnMore * weighted[cell] + around(weighted, cell);
    const float points = (kNoOffsetPoints + kOwnMore * weights[cell]) + around(weights, cell);
    limits[cell].level = map.height()[cell] + (steps / points) * kStep_m;
  }
  return limits;
}

/// III-F: each point's height above the level of its cell decides. Points that were set aside are
/// outliers if they lie well below the map, and labelled by their height over it if not.
LabelCounts label_points(const BinnedPoints& bins, const PerCell<CellLimit>& limits,
                         const ElevationMap& map, const Config& config, const Answers& answers) {
  LabelCounts counts;
  for (std::size_t i = 0; i < bins.cell.size(); ++i) {
    if (bins.cell[i] == BinnedPoints::kNoCell) {
      give(i, Label::unknown, std::numeric_limits<float>::quiet_NaN(), answers, counts);
      continue;
    }
    const std::uint32_t cell = bins.cell[i] & ~BinnedPoints::kOutlier;
    const bool aside = bins.is_outlier(i);
    const float level = aside ? map.height()[cell] : limits[cell].level;
    const float threshold =
        aside ? static_cast<float>(config.labels.ground_threshold_m) : limits[cell].threshold;
    const float height = static_cast<float>(bins.z[i]) * kStep_m - level;
    const bool deep = static_cast<double>(height) <= -kReflectionDepth_m;
    const Label by_height = height <= threshold ? Label::ground : Label::obstacle;
    give(i, aside && deep ? Label::outlier : by_height, height, answers, counts);
  }
  return counts;
}

}  // namespace

std::optional<LabelCounts> process(const Scan& scan, const Config& config, BinnedPoints& bins,
                                   ScanGrid& grid, PerCell<std::uint8_t>& on_surface,
                                   ElevationMap& map, const Answers& answers) {
  const Window window{map.size(), map.cell_size()};
  bin_points(scan.sensors, map, config, bins);
  filter_deep_outliers(scan, map, bins);
  paper::rasterize(bins, grid);
  if (contradicts_map(bins, grid, map)) return std::nullopt;
  const PerCell<std::uint8_t> supported = rasterize_supported(window, bins, grid);
  std::vector<GroundCell> cells;
  for (const std::uint32_t cell : grid.occupied)
    cells.push_back(classify_cell(scan, grid, window, cell, supported[cell] != 0));
  on_surface = compare_with_surface(grid, scan.ground, window, cells, map);
  update_elevation(grid, cells, config, map);
  map.mark_observed();
  fill(grid, cells, on_surface, scan.ground, config, window, map);
  PerCell<CellLimit> limits = choose_limits(bins, grid, map, config, window);
  if (config.labels.max_step_m > 0.0) {
    TileRunner one_thread(1);
    StepEdges(map).lower_limits(bins, grid, config, one_thread, limits);
  }
  return label_points(bins, limits, map, config, answers);
}

}  // namespace groundgrid::reference
