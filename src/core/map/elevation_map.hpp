#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "groundgrid/config.hpp"

namespace groundgrid {

/// A plane z(x, y) in the map frame: the ground under a vehicle whose base is at (x, y, z).
struct Plane {
  double x = 0.0;
  double y = 0.0;
  double z = 0.0;
  double slope_x = 0.0;
  double slope_y = 0.0;
  double offset = 0.0;  ///< Of the plane over z, at (x, y). Apart, so that x, y, z stay the pose's.
};

/// The rolling elevation map: what is known of the ground around the vehicle (paper III, intro).
///
/// A square window of size × size cells on a lattice that is anchored once; the window follows
/// the vehicle by whole cells and keeps what it knows. Inside the core everything is measured in
/// the window frame: metres from the outer corner of cell (0, 0), and heights above a z origin
/// near the vehicle, so that single precision is enough wherever on Earth the drive is.
class ElevationMap {
 public:
  explicit ElevationMap(const Config& config);

  [[nodiscard]] bool started() const { return started_; }
  /// Whether no scan has come in since the start: no cell has any confidence.
  [[nodiscard]] bool blank() const { return blank_; }
  void mark_observed() { blank_ = false; }
  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::size_t cells() const { return height_.size(); }
  [[nodiscard]] double cell_size() const { return cell_size_; }

  /// Sets every cell to the plane, with no confidence, and anchors the lattice if it is not yet.
  void start(const Plane& ground);

  /// Moves the window so that the plane's centre lies in its middle cell. Cells that come in take
  /// the plane's height and no confidence.
  void follow(const Plane& ground);

  /// Forgets the anchor too.
  void reset() { started_ = anchored_ = false; }

  /// Map frame coordinates of the window's corner and of height 0.
  [[nodiscard]] double min_x() const { return anchor_x_ + corner_x(); }
  [[nodiscard]] double min_y() const { return anchor_y_ + corner_y(); }
  [[nodiscard]] double z_origin() const { return anchor_z_ + z_offset_; }

  /// Map to window frame. The anchor goes first: a world moved by a vector that is exact in
  /// double then gives the same bits.
  [[nodiscard]] double window_x(double x) const { return (x - anchor_x_) - corner_x(); }
  [[nodiscard]] double window_y(double y) const { return (y - anchor_y_) - corner_y(); }
  [[nodiscard]] double window_z(double z) const { return (z - anchor_z_) - z_offset_; }

  /// The column or row of a window coordinate; the outermost one for coordinates outside.
  [[nodiscard]] int nearest_cell(float metres) const {
    const double cell = std::floor(static_cast<double>(metres) / cell_size_);
    return static_cast<int>(std::clamp(cell, 0.0, static_cast<double>(size_ - 1)));
  }

  [[nodiscard]] std::vector<float>& height() { return height_; }
  [[nodiscard]] const std::vector<float>& height() const { return height_; }
  [[nodiscard]] std::vector<float>& confidence() { return confidence_; }
  [[nodiscard]] const std::vector<float>& confidence() const { return confidence_; }

 private:
  [[nodiscard]] double corner_x() const {
    return (static_cast<double>(first_column_) - 0.5) * cell_size_;
  }
  [[nodiscard]] double corner_y() const {
    return (static_cast<double>(first_row_) - 0.5) * cell_size_;
  }
  [[nodiscard]] std::int64_t lattice_cell(double metres) const {
    return std::llround(std::floor(metres / cell_size_ + 0.5));
  }
  void anchor(const Plane& ground);
  void shift(std::int64_t columns, std::int64_t rows);
  void fill(int column_begin, int column_end, int row_begin, int row_end, const Plane& ground);
  void follow_z(double z);

  int size_;
  double cell_size_;
  std::optional<Point2> fixed_anchor_;
  bool started_ = false;
  bool blank_ = true;
  bool anchored_ = false;
  double anchor_x_ = 0.0;
  double anchor_y_ = 0.0;
  double anchor_z_ = 0.0;
  double z_offset_ = 0.0;          // of the z origin over the anchor, whole steps
  std::int64_t first_column_ = 0;  // lattice cell of the window's column 0
  std::int64_t first_row_ = 0;
  std::vector<float> height_;
  std::vector<float> confidence_;
};

/// Cells on each side of the vehicle's: the odd size puts the vehicle in the middle cell.
int window_half_size(const Config& config);

}  // namespace groundgrid
