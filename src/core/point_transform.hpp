#pragma once

#include <Eigen/Geometry>
#include <cstring>
#include <vector>

#include "groundgrid/scan.hpp"

namespace groundgrid {

struct Point3f {
  float x = 0.0F;
  float y = 0.0F;
  float z = 0.0F;
};

/// A rigid transform in single precision, for points within some hundred metres of the target's
/// origin.
struct PointTransform {
  float r[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
  float t[3] = {0, 0, 0};

  PointTransform() = default;
  explicit PointTransform(const Eigen::Isometry3d& transform);

  [[nodiscard]] Point3f apply(const Point3f& p) const {
    return {r[0] * p.x + r[1] * p.y + r[2] * p.z + t[0],
            r[3] * p.x + r[4] * p.y + r[5] * p.z + t[1],
            r[6] * p.x + r[7] * p.y + r[8] * p.z + t[2]};
  }
  [[nodiscard]] Point3f origin() const { return {t[0], t[1], t[2]}; }
};

inline Point3f load_point(const PointView& view, std::size_t index) {
  const std::byte* record = view.data + index * view.stride_bytes;
  Point3f point;
  std::memcpy(&point.x, record + view.x_offset, sizeof(float));
  std::memcpy(&point.y, record + view.y_offset, sizeof(float));
  std::memcpy(&point.z, record + view.z_offset, sizeof(float));
  return point;
}

/// Bytes of a point's time.
std::size_t size_of(TimeType type);

/// The time of a point of a view that has times.
double load_time(const PointView& view, std::size_t index);

/// Where one sensor was while it took one scan: a fixed transform, or, for scans that are not
/// motion-corrected, one for every moment, from the poses at the begin and the end. Positions
/// are interpolated linearly and rotations along the shortest arc (slerp); between the entries
/// of a table fine enough that the error stays below a tenth of a millimetre.
class SensorTrajectory {
 public:
  void set_fixed(const Eigen::Isometry3d& T_window_sensor);
  void set_moving(const Eigen::Isometry3d& T_window_base_begin,
                  const Eigen::Isometry3d& T_window_base_end,
                  const Eigen::Isometry3d& T_base_sensor, double time_begin, double time_end);

  /// The transform to the window frame for one point of the view.
  [[nodiscard]] PointTransform at(const PointView& view, std::size_t index) const {
    return moving_ ? blend(view, index) : end_;
  }
  [[nodiscard]] bool moving() const { return moving_; }
  /// The transform at the end of the scan, the map's moment.
  [[nodiscard]] const PointTransform& end() const { return end_; }

 private:
  static constexpr int kSteps = 256;
  [[nodiscard]] PointTransform blend(const PointView& view, std::size_t index) const;

  bool moving_ = false;
  PointTransform end_;
  double time_begin_ = 0.0;
  double steps_per_time_ = 0.0;
  std::vector<PointTransform> table_;
};

}  // namespace groundgrid
