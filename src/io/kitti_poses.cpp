#include "io/kitti_poses.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

#include "io/calibration.hpp"
#include "io/error.hpp"
#include "io/input_file.hpp"
#include "io/number_list.hpp"

namespace groundgrid::io {
namespace {

std::vector<std::string_view> lines_without_blank_end(std::string_view text) {
  std::vector<std::string_view> lines = split_lines(text);
  while (!lines.empty() && lines.back().find_first_not_of(" \t") == std::string_view::npos)
    lines.pop_back();
  return lines;
}

}  // namespace

KittiPoses::KittiPoses(std::filesystem::path poses, const std::filesystem::path& calibration)
    : path_(std::move(poses)) {
  const std::string text = read_text(path_);
  const Eigen::Isometry3d T_camera_lidar = read_lidar_calibration(calibration);
  const Eigen::Isometry3d T_lidar_camera = T_camera_lidar.inverse();
  const std::vector<std::string_view> lines = lines_without_blank_end(text);
  lidar_poses_.reserve(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    try {
      lidar_poses_.push_back(T_lidar_camera * parse_rigid_transform(lines[i]) * T_camera_lidar);
    } catch (const std::invalid_argument& problem) {
      throw Error({.file = path_,
                   .line = i + 1,
                   .expected = "the twelve numbers of a rigid transform",
                   .got = problem.what(),
                   .remedy = "mend the line, or use --single-scan to do without poses"});
    }
  }
}

const Eigen::Isometry3d& KittiPoses::pose(std::size_t scan_number) const {
  if (scan_number >= lidar_poses_.size())
    throw Error({.file = path_,
                 .line = scan_number + 1,
                 .expected = fmt::format("the pose of scan number {}", scan_number),
                 .got = fmt::format("the end of the file after {} lines", lidar_poses_.size()),
                 .remedy = "use the poses of the whole sequence, or --single-scan to do without"});
  return lidar_poses_[scan_number];
}

}  // namespace groundgrid::io
