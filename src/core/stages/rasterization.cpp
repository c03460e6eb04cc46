// Point cloud rasterization, paper III-B.
#include "core/stages/rasterization.hpp"

#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>

#include "core/kernels/marked_cells.hpp"
#include "core/kernels/point_kernels.hpp"

namespace groundgrid {
namespace {

// Points further above or below the z origin are outside the map: the squares of the heights of
// four million points up to 2^21 steps (209.7 m) fit into 64 bits.
constexpr float kHeightLimit_m = 209.0F;

/// Records of floats only that begin with x, y, z, as most do; none in any other layout.
PackedRecords packed_records(const PointView& view, const PointRange& range) {
  const bool packed = view.x_offset == 0 && view.y_offset == 4 && view.z_offset == 8 &&
                      (view.stride_bytes == 12 || view.stride_bytes == 16);
  const std::byte* first = view.data + range.begin * view.stride_bytes;
  if (!packed || reinterpret_cast<std::uintptr_t>(first) % alignof(float) != 0) return {};
  const std::size_t count = range.end - range.begin;
  return {reinterpret_cast<const float*>(first), view.stride_bytes / sizeof(float),
          count - count % kRecordsTogether};
}

/// Points [first, first + count) in their sensor's frame; those that are never taken are NaN.
void load_block(const SensorPass& pass, const Exclusion& exclusion, std::size_t first,
                std::size_t count, PointBlock& points) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i) {
    Point3f point = load_point(pass.points, first + i);
    if (exclusion.has_box && exclusion.is_in_box(point, pass.T_base_sensor)) point.x = kNan;
    points.x[i] = point.x;
    points.y[i] = point.y;
    points.z[i] = point.z;
  }
}

/// The same, moved to the window frame from where the sensor was at their times.
void load_moving(const SensorPass& pass, const Exclusion& exclusion, std::size_t first,
                 std::size_t count, PointBlock& points) {
  constexpr float kNan = std::numeric_limits<float>::quiet_NaN();
  for (std::size_t i = 0; i < count; ++i) {
    const Point3f point = load_point(pass.points, first + i);
    const Point3f moved = exclusion.takes(point, pass.T_base_sensor)
                              ? Point3f{kNan, kNan, kNan}
                              : pass.trajectory.at(pass.points, first + i).apply(point);
    points.x[i] = moved.x;
    points.y[i] = moved.y;
    points.z[i] = moved.z;
  }
}

}  // namespace

void bin_points(const SensorPass& pass, const PointRange& range, const WindowCells& window,
                const Exclusion& exclusion, BinnedPoints& bins) {
  const bool moving = pass.trajectory.moving();
  BinRule rule{window.extent, window.inverse_cell_size, window.size, kHeightLimit_m};
  if (!moving) {
    rule.min_range_squared = exclusion.min_range_squared;
    rule.transform = pass.trajectory.end();
  }
  std::size_t first = range.begin;
  if (!moving && !exclusion.has_box) {
    const PackedRecords records = packed_records(pass.points, range);
    bin_records(records, rule, bins.cell.data() + pass.first + first,
                bins.z.data() + pass.first + first);
    first += records.count;
  }
  // What a last, shorter block leaves of these at its end is worked on, too, for nothing.
  PointBlock points{};
  BinBlock binned{};
  for (; first < range.end; first += PointBlock::kMost) {
    const std::size_t number = std::min(PointBlock::kMost, range.end - first);
    if (moving)
      load_moving(pass, exclusion, first, number, points);
    else
      load_block(pass, exclusion, first, number, points);
    bin_block(points, rule, binned);
    std::copy_n(binned.cell, number, bins.cell.data() + pass.first + first);
    std::copy_n(binned.z, number, bins.z.data() + pass.first + first);
  }
}

void bin_points(const SensorPass& pass, const PointRange& range, const ElevationMap& map,
                const Config& config, BinnedPoints& bins) {
  bin_points(pass, range, WindowCells(map), Exclusion(config.vehicle), bins);
}

void bin_points(std::span<const SensorPass> sensors, const ElevationMap& map, const Config& config,
                BinnedPoints& bins) {
  for (const SensorPass& pass : sensors)
    bin_points(pass, {0, pass.points.count}, map, config, bins);
}

void clear(ScanGrid& grid) {
  for (const std::uint32_t cell : grid.occupied) {
    grid.statistics[cell] = CellStatistics{};
    grid.is_occupied[cell] = 0;
  }
  grid.occupied.clear();
}

void add_to_cells(const BinnedPoints& bins, const PointRange& range, const CellBand& band,
                  ScanGrid& grid) {
  add_points({bins.cell.data() + range.begin, bins.z.data() + range.begin, range.end - range.begin},
             band, grid.statistics.data(), grid.is_occupied.data());
}

void list_occupied(ScanGrid& grid) { append_marked(grid.is_occupied, 1, grid.occupied); }

}  // namespace groundgrid
