#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "groundgrid/scan.hpp"
#include "held_buffer.hpp"

namespace groundgrid::python {

/// Times of points, and the interval that they span.
struct PointTimes {
  HeldBuffer values;
  double begin;
  double end;
};

/// The points of one scan in an array of N × 3 or more numbers, float32 or float64. Made and
/// destroyed with the GIL held; the rest needs no GIL.
class PointArray {
 public:
  /// Throws TypeError or ValueError, which begin with "points" or "times", where the arrays are of
  /// another type or shape, and ValueError for more points than one call takes.
  explicit PointArray(nb::handle points, nb::handle times = nb::none());

  [[nodiscard]] std::size_t size() const { return points_.length(0); }

  /// A view of the points: of the array itself where they are float32 and one point lies after the
  /// other, else of a copy in `records`, which must outlive the view.
  PointView view(std::vector<std::byte>& records) const;

  /// First and last byte that belong to the points, for none of which an output may be.
  [[nodiscard]] std::pair<const std::byte*, const std::byte*> extent() const;

 private:
  [[nodiscard]] bool is_viewable() const;
  [[nodiscard]] float coordinate(std::size_t point, int axis) const;
  [[nodiscard]] double time(std::size_t point) const;

  HeldBuffer points_;
  bool is_float64_;
  std::optional<HeldBuffer> times_;
};

}  // namespace groundgrid::python
