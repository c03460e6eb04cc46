#pragma once

#include <Eigen/Geometry>
#include <array>

namespace groundgrid {

/// A rotation and a translation as 3×4 doubles, row by row: [R | t].
///
/// It stands wherever a pose is stored in a struct, so that the layout of our structs never
/// depends on the vector extensions the consumer's compiler was told to use (Eigen's types do).
struct RigidTransform {
  std::array<double, 12> rows{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};

  RigidTransform() = default;

  /// From Eigen; not explicit, so that poses can be handed over as they are.
  RigidTransform(const Eigen::Isometry3d& transform) {  // NOLINT(google-explicit-constructor)
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        rows[static_cast<std::size_t>(row * 4 + column)] = transform(row, column);
  }

  [[nodiscard]] Eigen::Isometry3d isometry() const {
    Eigen::Isometry3d transform = Eigen::Isometry3d::Identity();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 4; ++column)
        transform(row, column) = rows[static_cast<std::size_t>(row * 4 + column)];
    return transform;
  }
};

}  // namespace groundgrid
