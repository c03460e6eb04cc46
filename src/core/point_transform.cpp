#include "core/point_transform.hpp"

#include <algorithm>
#include <cstdint>

namespace groundgrid {
namespace {

template <typename Value>
Value load(const std::byte* bytes) {
  Value value;
  std::memcpy(&value, bytes, sizeof(value));
  return value;
}

}  // namespace

PointTransform::PointTransform(const Eigen::Isometry3d& transform) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column)
      r[row * 3 + column] = static_cast<float>(transform(row, column));
    t[row] = static_cast<float>(transform(row, 3));
  }
}

void SensorTrajectory::set_fixed(const Eigen::Isometry3d& T_window_sensor) {
  moving_ = false;
  end_ = PointTransform(T_window_sensor);
}

void SensorTrajectory::set_moving(const Eigen::Isometry3d& T_window_base_begin,
                                  const Eigen::Isometry3d& T_window_base_end,
                                  const Eigen::Isometry3d& T_base_sensor, double time_begin,
                                  double time_end) {
  moving_ = true;
  end_ = PointTransform(T_window_base_end * T_base_sensor);
  time_begin_ = time_begin;
  steps_per_time_ = kSteps / (time_end - time_begin);
  table_.resize(kSteps + 1);
  const Eigen::Quaterniond q_begin(T_window_base_begin.linear());
  const Eigen::Quaterniond q_end(T_window_base_end.linear());
  for (int step = 0; step <= kSteps; ++step) {
    const double share = static_cast<double>(step) / kSteps;
    Eigen::Isometry3d T_window_base = Eigen::Isometry3d::Identity();
    T_window_base.linear() = q_begin.slerp(share, q_end).toRotationMatrix();
    T_window_base.translation() =
        (1.0 - share) * T_window_base_begin.translation() + share * T_window_base_end.translation();
    table_[static_cast<std::size_t>(step)] = PointTransform(T_window_base * T_base_sensor);
  }
}

std::size_t size_of(TimeType type) {
  return type == TimeType::float64 ? sizeof(double) : sizeof(std::uint32_t);
}

double load_time(const PointView& view, std::size_t index) {
  const std::byte* field = view.data + index * view.stride_bytes + *view.time_offset;
  switch (view.time_type) {
    case TimeType::float32:
      return static_cast<double>(load<float>(field));
    case TimeType::uint32:
      return static_cast<double>(load<std::uint32_t>(field));
    case TimeType::float64:
      break;
  }
  return load<double>(field);
}

PointTransform SensorTrajectory::blend(const PointView& view, std::size_t index) const {
  const double time = load_time(view, index);
  // Times outside the scan, and NaN, take the nearer end: the point keeps its place in the answer.
  double position = (time - time_begin_) * steps_per_time_;
  if (!(position > 0.0)) position = 0.0;
  position = std::min(position, static_cast<double>(kSteps));
  const int step = std::min(static_cast<int>(position), kSteps - 1);
  const auto share = static_cast<float>(position - step);
  const PointTransform& a = table_[static_cast<std::size_t>(step)];
  const PointTransform& b = table_[static_cast<std::size_t>(step) + 1];
  PointTransform result;
  for (int i = 0; i < 9; ++i) result.r[i] = a.r[i] + share * (b.r[i] - a.r[i]);
  for (int i = 0; i < 3; ++i) result.t[i] = a.t[i] + share * (b.t[i] - a.t[i]);
  return result;
}

}  // namespace groundgrid
