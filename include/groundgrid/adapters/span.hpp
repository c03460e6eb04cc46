#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>

#include "groundgrid/scan.hpp"

namespace groundgrid {

/// A point type with float members x, y, z.
template <typename Point>
concept PointLike = std::is_standard_layout_v<Point> && requires(const Point& point) {
  { point.x } -> std::convertible_to<const float&>;
  { point.y } -> std::convertible_to<const float&>;
  { point.z } -> std::convertible_to<const float&>;
};

/// A view of points of the caller's own type, without a copy. The span must outlive the view.
template <PointLike Point>
PointView view_of(std::span<const Point> points) {
  PointView view;
  view.data = reinterpret_cast<const std::byte*>(points.data());
  view.count = points.size();
  view.stride_bytes = sizeof(Point);
  view.x_offset = offsetof(Point, x);
  view.y_offset = offsetof(Point, y);
  view.z_offset = offsetof(Point, z);
  return view;
}

}  // namespace groundgrid
