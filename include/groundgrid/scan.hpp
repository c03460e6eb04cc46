#pragma once

#include <cstddef>
#include <optional>

#include "groundgrid/rigid_transform.hpp"

namespace groundgrid {

/// How drivers write the time of a point.
enum class TimeType {
  float32,  ///< Velodyne: seconds from the scan's begin or end.
  float64,  ///< Seconds.
  uint32,   ///< Ouster: nanoseconds from the scan's begin.
};

/// A non-owning view of a point cloud as it lies in memory: `count` records of `stride_bytes`
/// bytes, with the coordinates as 32-bit floats in metres at the given offsets (any alignment).
struct PointView {
  const std::byte* data = nullptr;
  std::size_t count = 0;
  std::size_t stride_bytes = 0;
  std::size_t x_offset = 0;
  std::size_t y_offset = 4;
  std::size_t z_offset = 8;
  /// Offset of the time of each point, where there is one, in the unit of SensorScan's times.
  std::optional<std::size_t> time_offset{};
  TimeType time_type = TimeType::float64;

  /// Packed records of `floats_per_point` floats that begin with x, y, z (KITTI: 4, nuScenes: 5).
  static PointView from_floats(const float* data, std::size_t count, std::size_t floats_per_point) {
    return {reinterpret_cast<const std::byte*>(data), count, floats_per_point * sizeof(float)};
  }
};

/// The points that one sensor delivered in one scan, in the frame of that sensor.
struct SensorScan {
  PointView points;
  /// Where the sensor sits on the vehicle. Base is on the ground under the vehicle, x forward,
  /// z up. Left out: the points are in base itself (a lone LiDAR whose pose is the LiDAR's own)
  /// and the ground lies the sensor height below it; see Config::sensor_height_m.
  std::optional<RigidTransform> T_base_sensor{};
  /// The interval that the point times span. Used only with poses of begin and end.
  double time_begin = 0.0;
  double time_end = 0.0;
};

}  // namespace groundgrid
