#include "program/scan_reading.hpp"

#include <fmt/format.h>

#include <cstring>
#include <vector>

#include "io/error.hpp"
#include "io/number_list.hpp"
#include "io/scan_file.hpp"

namespace groundgrid::program {
namespace {

Eigen::Vector3f point_at(const PointView& points, std::size_t i) {
  const std::byte* const record = points.data + i * points.stride_bytes;
  Eigen::Vector3f point;
  std::memcpy(&point.x(), record + points.x_offset, sizeof(float));
  std::memcpy(&point.y(), record + points.y_offset, sizeof(float));
  std::memcpy(&point.z(), record + points.z_offset, sizeof(float));
  return point;
}

void turn(const Eigen::Matrix3f& rotation, std::vector<float>& coordinates) {
  for (std::size_t i = 0; i < coordinates.size(); i += 3) {
    Eigen::Map<Eigen::Vector3f> point(&coordinates[i]);
    point = (rotation * point).eval();
  }
}

}  // namespace

void copy_coordinates(const PointView& points, std::vector<float>& coordinates) {
  coordinates.resize(points.count * 3);
  for (std::size_t i = 0; i < points.count; ++i)
    Eigen::Vector3f::Map(&coordinates[3 * i]) = point_at(points, i);
}

std::string viewpoint_remark(const io::PointCloud& cloud) {
  const std::vector<double> origin{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  if (cloud.viewpoint.empty() || io::parse_numbers(cloud.viewpoint) == origin) return "";
  return fmt::format(
      "VIEWPOINT {} is not used: the points are taken to be in the LiDAR's own frame. If they are "
      "in "
      "that of a map, give the LiDAR's poses and clouds in its frame",
      cloud.viewpoint);
}

void read_into_slot(const io::ScanFile& scan, const Eigen::Matrix3d& R_level_lidar,
                    ScanSlot& slot) {
  io::read_scan(scan, slot.cloud);
  if (slot.cloud.size() == 0)
    throw io::Error(
        {.file = scan.path, .expected = "a scan", .got = "a file that holds no points"});
  slot.points = io::point_view(slot.cloud, slot.coordinates);
  if (R_level_lidar == Eigen::Matrix3d::Identity()) return;
  if (slot.points.data == slot.cloud.data.data()) copy_coordinates(slot.points, slot.coordinates);
  turn(R_level_lidar.cast<float>(), slot.coordinates);
  slot.points = PointView::from_floats(slot.coordinates.data(), slot.cloud.size(), 3);
}

}  // namespace groundgrid::program
