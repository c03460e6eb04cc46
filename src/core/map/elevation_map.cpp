#include "core/map/elevation_map.hpp"

#include <algorithm>

namespace groundgrid {
namespace {

// The z origin follows the vehicle in steps this large: heights stay small enough for single
// precision, and rounding by the step is rare.
constexpr double kZOriginStep_m = 64.0;

/// The whole steps in an offset; less than a whole one is none.
double steps_to(double offset) { return std::trunc(offset / kZOriginStep_m) * kZOriginStep_m; }

}  // namespace

int window_half_size(const Config& config) {
  return static_cast<int>(std::ceil(config.map.extent_m / (2.0 * config.map.resolution_m) - 0.5));
}

ElevationMap::ElevationMap(const Config& config)
    : size_(2 * window_half_size(config) + 1),
      cell_size_(config.map.resolution_m),
      fixed_anchor_(config.map.anchor_m) {
  const auto cells = static_cast<std::size_t>(size_) * static_cast<std::size_t>(size_);
  height_.resize(cells);
  confidence_.resize(cells);
}

void ElevationMap::anchor(const Plane& ground) {
  const Point2 place = fixed_anchor_.value_or(Point2{ground.x, ground.y});
  anchor_x_ = place[0];
  anchor_y_ = place[1];
  anchor_z_ = ground.z;
  anchored_ = true;
}

void ElevationMap::start(const Plane& ground) {
  if (!anchored_) anchor(ground);
  z_offset_ = steps_to(window_z(ground.z) + z_offset_);
  first_column_ = lattice_cell(ground.x - anchor_x_) - size_ / 2;
  first_row_ = lattice_cell(ground.y - anchor_y_) - size_ / 2;
  fill(0, size_, 0, size_, ground);
  started_ = blank_ = true;
}

void ElevationMap::follow(const Plane& ground) {
  follow_z(ground.z);
  const std::int64_t columns = lattice_cell(ground.x - anchor_x_) - size_ / 2 - first_column_;
  const std::int64_t rows = lattice_cell(ground.y - anchor_y_) - size_ / 2 - first_row_;
  if (columns == 0 && rows == 0) return;
  first_column_ += columns;
  first_row_ += rows;
  const auto limit = static_cast<std::int64_t>(size_);
  if (std::abs(columns) >= limit || std::abs(rows) >= limit) {
    fill(0, size_, 0, size_, ground);
    blank_ = true;
    return;
  }
  shift(columns, rows);
  const int dx = static_cast<int>(columns);
  const int dy = static_cast<int>(rows);
  if (dx > 0) fill(size_ - dx, size_, 0, size_, ground);
  if (dx < 0) fill(0, -dx, 0, size_, ground);
  if (dy > 0) fill(0, size_, size_ - dy, size_, ground);
  if (dy < 0) fill(0, size_, 0, -dy, ground);
}

void ElevationMap::shift(std::int64_t columns, std::int64_t rows) {
  const std::int64_t width = size_ - std::abs(columns);
  const std::int64_t from_column = std::max<std::int64_t>(columns, 0);
  const std::int64_t to_column = std::max<std::int64_t>(-columns, 0);
  const auto move_row = [&](std::vector<float>& layer, std::int64_t to) {
    const auto from = layer.begin() + (to + rows) * size_ + from_column;
    const auto target = layer.begin() + to * size_ + to_column;
    if (target < from)
      std::copy(from, from + width, target);
    else
      std::copy_backward(from, from + width, target + width);
  };
  const std::int64_t height = size_ - std::abs(rows);
  const std::int64_t first_row = std::max<std::int64_t>(-rows, 0);
  // Rows are moved in the order in which none is overwritten before it has been read.
  for (std::int64_t i = 0; i < height; ++i) {
    const std::int64_t row = rows >= 0 ? first_row + i : first_row + height - 1 - i;
    move_row(height_, row);
    move_row(confidence_, row);
  }
}

void ElevationMap::fill(int column_begin, int column_end, int row_begin, int row_end,
                        const Plane& ground) {
  const double x0 = 0.5 * cell_size_ - window_x(ground.x);
  const double y0 = 0.5 * cell_size_ - window_y(ground.y);
  const double z0 = window_z(ground.z) + ground.offset;
  for (int row = row_begin; row < row_end; ++row) {
    const double z_row = z0 + ground.slope_y * (y0 + row * cell_size_);
    for (int column = column_begin; column < column_end; ++column) {
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
                        static_cast<std::size_t>(column);
      height_[cell] = static_cast<float>(z_row + ground.slope_x * (x0 + column * cell_size_));
      confidence_[cell] = 0.0F;
    }
  }
}

void ElevationMap::follow_z(double z) {
  const double offset = steps_to(window_z(z));
  if (offset == 0.0) return;
  z_offset_ += offset;
  const auto shift_by = static_cast<float>(offset);
  for (float& height : height_) height -= shift_by;
}

}  // namespace groundgrid
