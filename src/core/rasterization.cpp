// Point cloud rasterization, paper III-B.
#include "core/rasterization.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace groundgrid {
namespace {

constexpr std::size_t kPointsPerTile = 8192;
constexpr float kStepsPerMetre = 1e4F;
constexpr float kMaxHeight_m = 1e5F;
// Squares of heights up to 209 m (2^21 steps) of two million points fit into 63 bits.
constexpr std::int32_t kMaxSteps = 1 << 21;

/// Points that are never taken: on the own vehicle, or too near to the sensor.
struct Exclusion {
  float min[3];
  float max[3];
  float min_range_squared;
  bool has_box;

  explicit Exclusion(const Config& config)
      : min{static_cast<float>(config.own_vehicle_min_x_m),
            static_cast<float>(config.own_vehicle_min_y_m),
            static_cast<float>(config.own_vehicle_min_z_m)},
        max{static_cast<float>(config.own_vehicle_max_x_m),
            static_cast<float>(config.own_vehicle_max_y_m),
            static_cast<float>(config.own_vehicle_max_z_m)},
        min_range_squared(static_cast<float>(config.min_range_m * config.min_range_m)),
        has_box(min[0] < max[0] && min[1] < max[1] && min[2] < max[2]) {}

  [[nodiscard]] bool takes(const Point3f& in_sensor, const PointTransform& T_base_sensor) const {
    const float range_squared =
        in_sensor.x * in_sensor.x + in_sensor.y * in_sensor.y + in_sensor.z * in_sensor.z;
    if (range_squared < min_range_squared) return true;
    if (!has_box) return false;
    const Point3f p = T_base_sensor.apply(in_sensor);
    return p.x >= min[0] && p.x <= max[0] && p.y >= min[1] && p.y <= max[1] && p.z >= min[2] &&
           p.z <= max[2];
  }
};

/// The window's cells as single precision arithmetic sees them.
struct Binning {
  float extent;
  float inverse_cell_size;
  int size;

  [[nodiscard]] std::uint32_t cell_of(const Point3f& p) const {
    // Written so that NaN fails.
    const bool inside =
        p.x >= 0.0F && p.x < extent && p.y >= 0.0F && p.y < extent && std::abs(p.z) < kMaxHeight_m;
    if (!inside) return BinnedPoints::kNoCell;
    const int column = std::min(static_cast<int>(p.x * inverse_cell_size), size - 1);
    const int row = std::min(static_cast<int>(p.y * inverse_cell_size), size - 1);
    return static_cast<std::uint32_t>(row * size + column);
  }
};

template <typename TransformOf>
void bin_tile(const SensorPass& pass, std::size_t tile, const Exclusion& exclusion,
              const Binning& binning, BinnedPoints& bins, const TransformOf& transform_of) {
  const std::size_t begin = tile * kPointsPerTile;
  const std::size_t end = std::min(begin + kPointsPerTile, pass.points.count);
  for (std::size_t i = begin; i < end; ++i) {
    const Point3f p = load_point(pass.points, i);
    const Point3f q = transform_of(i).apply(p);
    std::uint32_t cell = binning.cell_of(q);
    if (exclusion.takes(p, pass.T_base_sensor)) cell = BinnedPoints::kNoCell;
    bins.cell[pass.first + i] = cell;
    bins.z[pass.first + i] = cell == BinnedPoints::kNoCell
                                 ? 0
                                 : static_cast<std::int32_t>(std::lrint(q.z * kStepsPerMetre));
  }
}

void add_point(CellStatistics& cell, std::int32_t z) {
  const std::int64_t height = std::clamp(z, -kMaxSteps, kMaxSteps);
  const auto steps = static_cast<std::int32_t>(height);
  cell.min = cell.count == 0 ? steps : std::min(cell.min, steps);
  cell.max = cell.count == 0 ? steps : std::max(cell.max, steps);
  cell.sum += height;
  cell.sum_squares += height * height;
  ++cell.count;
}

void clear(ScanGrid& grid) {
  for (const std::uint32_t cell : grid.occupied) {
    grid.statistics[cell] = CellStatistics{};
    grid.is_occupied[cell] = 0;
  }
  grid.occupied.clear();
}

void list_occupied_cells(ScanGrid& grid) {
  const std::size_t cells = grid.is_occupied.size();
  std::size_t cell = 0;
  for (; cell + 8 <= cells; cell += 8) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, &grid.is_occupied[cell], sizeof(eight));
    if (eight == 0) continue;
    for (std::size_t i = cell; i < cell + 8; ++i)
      if (grid.is_occupied[i] != 0) grid.occupied.push_back(static_cast<std::uint32_t>(i));
  }
  for (; cell < cells; ++cell)
    if (grid.is_occupied[cell] != 0) grid.occupied.push_back(static_cast<std::uint32_t>(cell));
}

}  // namespace

void bin_points(const SensorPass& pass, const ElevationMap& map, const Config& config,
                TileRunner& runner, BinnedPoints& bins) {
  const Exclusion exclusion(config);
  const auto cell_size = static_cast<float>(map.cell_size());
  const Binning binning{static_cast<float>(map.size()) * cell_size, 1.0F / cell_size, map.size()};
  const std::size_t tiles = (pass.points.count + kPointsPerTile - 1) / kPointsPerTile;
  if (pass.trajectory.moving()) {
    runner.parallel_for_tiles(tiles, [&](std::size_t tile) {
      bin_tile(pass, tile, exclusion, binning, bins,
               [&](std::size_t i) { return pass.trajectory.at(pass.points, i); });
    });
  } else {
    // A copy of its own stays in registers.
    const PointTransform T_window_sensor = pass.trajectory.end();
    runner.parallel_for_tiles(tiles, [&](std::size_t tile) {
      bin_tile(pass, tile, exclusion, binning, bins,
               [&](std::size_t) -> const PointTransform& { return T_window_sensor; });
    });
  }
}

void rasterize(const BinnedPoints& bins, std::span<const Label> labels, TileRunner& runner,
               ScanGrid& grid) {
  clear(grid);
  for_each_binned_point(bins, labels, grid.statistics.size(), runner,
                        [&](std::uint32_t cell, std::int32_t z) {
                          add_point(grid.statistics[cell], z);
                          grid.is_occupied[cell] = 1;
                        });
  list_occupied_cells(grid);
}

}  // namespace groundgrid
