#pragma once

#include <concepts>
#include <cstddef>
#include <span>
#include <type_traits>
#include <vector>

#include "groundgrid/scan.hpp"

namespace groundgrid {

/// A point type with float members x, y, z.
template <typename Point>
concept PointLike = std::is_standard_layout_v<Point> && requires(const Point& point) {
  { (point.x) } -> std::same_as<const float&>;
  { (point.y) } -> std::same_as<const float&>;
  { (point.z) } -> std::same_as<const float&>;
};

/// A view of points of the caller's own type, without a copy. The points must outlive the view.
template <typename Point, std::size_t Extent>
requires PointLike<std::remove_const_t<Point>> PointView view_of(std::span<Point, Extent> points) {
  using Record = std::remove_const_t<Point>;
  PointView view;
  view.data = reinterpret_cast<const std::byte*>(points.data());
  view.count = points.size();
  view.stride_bytes = sizeof(Record);
  view.x_offset = offsetof(Record, x);
  view.y_offset = offsetof(Record, y);
  view.z_offset = offsetof(Record, z);
  return view;
}

template <PointLike Point, typename Allocator>
PointView view_of(const std::vector<Point, Allocator>& points) {
  return view_of(std::span(points));
}

}  // namespace groundgrid
