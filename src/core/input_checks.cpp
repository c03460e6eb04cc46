#include "core/input_checks.hpp"

#include <stdexcept>
#include <string>

#include "core/point_transform.hpp"
#include "groundgrid/ground_grid.hpp"

namespace groundgrid {
namespace {

constexpr double kRigidTolerance = 1e-3;
/// Further out no double tells one cell from the next.
constexpr double kMaxPosition_m = 1e9;

void check_pose(const Eigen::Isometry3d& pose, const char* name) {
  const Eigen::Matrix3d rotation = pose.linear();
  if (!pose.matrix().allFinite())
    throw std::invalid_argument(std::string(name) + " holds NaN or infinite values");
  if (pose.translation().cwiseAbs().maxCoeff() > kMaxPosition_m)
    throw std::invalid_argument(std::string(name) + " is more than 1e9 m from the origin");
  const double error = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).norm();
  if (error > kRigidTolerance || rotation.determinant() < 0.0)
    throw std::invalid_argument(std::string(name) +
                                " is not rigid: its rotation is not orthonormal");
}

void check_offset(const PointView& view, std::size_t offset, std::size_t bytes, const char* name) {
  if (offset > view.stride_bytes || view.stride_bytes - offset < bytes)
    throw std::invalid_argument("PointView: the offset of " + std::string(name) +
                                " does not fit into stride_bytes");
}

}  // namespace

void check_view(const PointView& view) {
  if (view.count == 0) return;
  if (view.data == nullptr) throw std::invalid_argument("PointView: data is null");
  check_offset(view, view.x_offset, sizeof(float), "x");
  check_offset(view, view.y_offset, sizeof(float), "y");
  check_offset(view, view.z_offset, sizeof(float), "z");
  if (view.time_offset) check_offset(view, *view.time_offset, size_of(view.time_type), "time");
}

void check_input(std::span<const SensorScan> scans, const Motion& motion) {
  check_pose(motion.T_map_base_begin, "T_map_base_begin");
  check_pose(motion.T_map_base_end, "T_map_base_end");
  const Eigen::Vector3d way =
      motion.T_map_base_end.translation() - motion.T_map_base_begin.translation();
  if (way.norm() > kPoseJump_m)
    throw std::invalid_argument("T_map_base_begin and T_map_base are more than 20 m apart");
  std::size_t points = 0;
  for (const SensorScan& scan : scans) {
    check_view(scan.points);
    if (scan.T_base_sensor) check_pose(scan.T_base_sensor->isometry(), "T_base_sensor");
    if (motion.within_scan && scan.points.time_offset && !(scan.time_end > scan.time_begin))
      throw std::invalid_argument("SensorScan: time_end must be later than time_begin");
    // Not the sum of all: counts of any size could wrap round to a small one.
    if (scan.points.count > kMaxPointsPerCall - points)
      throw std::invalid_argument("more than 4194304 points in one call; hand them over in parts");
    points += scan.points.count;
  }
}

}  // namespace groundgrid
