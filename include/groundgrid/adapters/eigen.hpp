#pragma once

#include <Eigen/Core>
#include <cstddef>

#include "groundgrid/scan.hpp"

namespace groundgrid {

/// A view of a float matrix with one point a column (x, y, z and any further rows), column by
/// column in memory, without a copy. The matrix must outlive the view.
template <int Rows, int Options, int MaxRows, int MaxColumns>
PointView view_of(
    const Eigen::Matrix<float, Rows, Eigen::Dynamic, Options, MaxRows, MaxColumns>& points) {
  static_assert(Rows >= 3 && (Options & Eigen::RowMajor) == 0,
                "one point a column, at least three rows");
  return PointView::from_floats(points.data(), static_cast<std::size_t>(points.cols()),
                                static_cast<std::size_t>(Rows));
}

/// A view of a float matrix with one point a row, row by row in memory, without a copy.
template <int Columns, int MaxRows, int MaxColumns>
PointView view_of(const Eigen::Matrix<float, Eigen::Dynamic, Columns, Eigen::RowMajor, MaxRows,
                                      MaxColumns>& points) {
  static_assert(Columns >= 3, "one point a row, at least three columns");
  return PointView::from_floats(points.data(), static_cast<std::size_t>(points.rows()),
                                static_cast<std::size_t>(Columns));
}

}  // namespace groundgrid
