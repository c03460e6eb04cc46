#pragma once

#include <algorithm>
#include <cstddef>
#include <limits>

#include "core/point_transform.hpp"
#include "groundgrid/config.hpp"

namespace groundgrid {

/// Points that are never taken: on the ego vehicle, too near to the sensor, or at its very origin,
/// which is how drivers and organised clouds write a ray without a return.
struct Exclusion {
  float min[3]{};
  float max[3]{};
  float min_range_squared;
  bool has_box;

  explicit Exclusion(const Config::Vehicle& vehicle)
      : min_range_squared(std::max(static_cast<float>(vehicle.min_range_m * vehicle.min_range_m),
                                   std::numeric_limits<float>::min())),
        has_box(vehicle.ego_vehicle_box_m.has_value()) {
    const Box box = vehicle.ego_vehicle_box_m.value_or(Box{});
    for (std::size_t axis = 0; axis < 3; ++axis) {
      min[axis] = static_cast<float>(box[2 * axis]);
      max[axis] = static_cast<float>(box[2 * axis + 1]);
    }
  }

  [[nodiscard]] bool is_in_box(const Point3f& in_sensor,
                               const PointTransform& T_base_sensor) const {
    const Point3f p = T_base_sensor.apply(in_sensor);
    return p.x >= min[0] && p.x <= max[0] && p.y >= min[1] && p.y <= max[1] && p.z >= min[2] &&
           p.z <= max[2];
  }

  [[nodiscard]] bool takes(const Point3f& in_sensor, const PointTransform& T_base_sensor) const {
    const float range_squared =
        in_sensor.x * in_sensor.x + in_sensor.y * in_sensor.y + in_sensor.z * in_sensor.z;
    return range_squared < min_range_squared || (has_box && is_in_box(in_sensor, T_base_sensor));
  }
};

}  // namespace groundgrid
