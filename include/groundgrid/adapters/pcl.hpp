#pragma once

#include <span>

#include "groundgrid/adapters/span.hpp"

namespace groundgrid {

/// A view of a pcl::PointCloud of any point type with x, y, z, without a copy. A template, so that
/// this header needs no PCL. The cloud must outlive the view.
template <typename Cloud>
requires PointLike<typename Cloud::PointType> PointView view_of(const Cloud& cloud) {
  using Point = typename Cloud::PointType;
  return view_of(std::span<const Point>(cloud.points.data(), cloud.points.size()));
}

}  // namespace groundgrid
