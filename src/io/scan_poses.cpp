#include "io/scan_poses.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>

#include "io/calibration.hpp"
#include "io/error.hpp"
#include "io/path_checks.hpp"

namespace groundgrid::io {
namespace {

// A scan's time may be that of its middle or end, so the first or last may lie just outside.
constexpr double kMostBesides_s = 0.1;

Eigen::Isometry3d between(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b, double share) {
  const Eigen::Quaterniond rotation =
      Eigen::Quaterniond(a.linear()).slerp(share, Eigen::Quaterniond(b.linear()));
  const Eigen::Vector3d translation = (1.0 - share) * a.translation() + share * b.translation();
  return Eigen::Translation3d(translation) * rotation.normalized();
}

[[noreturn]] void fail_missing(const std::filesystem::path& path, std::size_t index,
                               std::string_view what, std::size_t lines) {
  throw Error({.file = path,
               .line = index + 1,
               .expected = fmt::format("the {} of scan number {}", what, index),
               .got = fmt::format("the end of the file after {} lines", lines),
               .remedy = "use the file of the whole sequence, or --single-scan to do without "
                         "poses"});
}

}  // namespace

ScanPoses::ScanPoses(std::filesystem::path path, PoseList list)
    : path_(std::move(path)), list_(std::move(list)) {}

ScanPoses ScanPoses::kitti(const std::filesystem::path& poses,
                           const std::filesystem::path& calibration) {
  ScanPoses result(poses, read_kitti_poses(poses));
  result.turn_into_lidar_poses(calibration);
  return result;
}

ScanPoses ScanPoses::of_dataset(const ScanSequence& sequence) {
  if (!sequence.is_kitti_360()) return kitti(sequence.poses(), sequence.calibration());
  const std::filesystem::path calibration = sequence.calibration();
  return from_file(sequence.poses(), sequence,
                   is_there(calibration) ? std::optional(calibration) : std::nullopt);
}

ScanPoses ScanPoses::from_file(const std::filesystem::path& poses, const ScanSequence& sequence,
                               const std::optional<std::filesystem::path>& calibration) {
  ScanPoses result(poses, read_pose_file(poses));
  if (calibration) result.turn_into_lidar_poses(*calibration);
  if (!result.list_.numbers.empty()) {
    result.require_a_pose(sequence);
    return result;
  }
  if (!result.list_.times.empty() && is_there(sequence.times())) {
    result.times_path_ = sequence.times();
    result.scan_times_ = read_scan_times(result.times_path_);
    result.line_ = matching_line(result.times_path_, result.scan_times_.size(), sequence);
  } else {
    result.line_ = matching_line(poses, result.size(), sequence);
  }
  return result;
}

std::size_t ScanPoses::size() const { return list_.poses.size(); }

Eigen::Isometry3d ScanPoses::first() const {
  return list_.poses.empty() ? Eigen::Isometry3d::Identity() : list_.poses.front();
}

bool ScanPoses::leaves_out(const ScanFile& scan) const {
  return !list_.numbers.empty() &&
         !std::binary_search(list_.numbers.begin(), list_.numbers.end(), scan.number);
}

Eigen::Isometry3d ScanPoses::pose(const ScanFile& scan) const {
  if (leaves_out(scan))
    throw Error({.file = path_,
                 .expected = fmt::format("a line for scan number {}", scan.number),
                 .got = "none",
                 .remedy = "leave the scan out, or use --single-scan to do without poses"});
  if (!list_.numbers.empty())
    return list_.poses[static_cast<std::size_t>(
        std::lower_bound(list_.numbers.begin(), list_.numbers.end(), scan.number) -
        list_.numbers.begin())];
  if (!scan_times_.empty()) return pose_at_scan_time(scan);
  const std::size_t index = index_of(scan, line_);
  if (index >= size()) fail_missing(path_, index, "pose", size());
  return list_.poses[index];
}

void ScanPoses::require_a_pose(const ScanSequence& sequence) const {
  for (const ScanFile& scan : sequence.scans)
    if (!leaves_out(scan)) return;
  throw Error({.file = path_,
               .expected = fmt::format("a line for any of the scans {} to {}",
                                       sequence.scans.front().name, sequence.scans.back().name),
               .got = fmt::format("lines for the numbers {} to {}", list_.numbers.front(),
                                  list_.numbers.back()),
               .remedy = "use the poses of this sequence, or --single-scan to do without"});
}

ScanPoses::Line ScanPoses::matching_line(const std::filesystem::path& path, std::size_t lines,
                                         const ScanSequence& sequence) {
  const auto last =
      std::max_element(sequence.scans.begin(), sequence.scans.end(),
                       [](const ScanFile& a, const ScanFile& b) { return a.number < b.number; });
  if (last->number < lines) return Line::of_its_number;
  if (sequence.scans.size() == lines) return Line::of_its_place;
  throw Error(
      {.file = path,
       .expected = fmt::format("a line for each of the {} scans, or for every number up to "
                               "that of {}",
                               sequence.scans.size(), last->path.string()),
       .got = fmt::format("{} lines", lines),
       .remedy = "use the file of the whole sequence, or --single-scan to do without poses"});
}

std::size_t ScanPoses::index_of(const ScanFile& scan, Line line) {
  return line == Line::of_its_number ? scan.number : scan.index;
}

void ScanPoses::turn_into_lidar_poses(const std::filesystem::path& calibration) {
  if (is_folder(calibration)) {
    const Eigen::Isometry3d T_vehicle_lidar = read_kitti_360_mounting(calibration);
    for (Eigen::Isometry3d& pose : list_.poses) pose = pose * T_vehicle_lidar;
    return;
  }
  const Eigen::Isometry3d T_camera_lidar = read_lidar_calibration(calibration);
  const Eigen::Isometry3d T_lidar_camera = T_camera_lidar.inverse();
  for (Eigen::Isometry3d& pose : list_.poses) pose = T_lidar_camera * pose * T_camera_lidar;
}

Eigen::Isometry3d ScanPoses::pose_at_scan_time(const ScanFile& scan) const {
  const std::size_t index = index_of(scan, line_);
  if (index >= scan_times_.size()) fail_missing(times_path_, index, "time", scan_times_.size());
  const std::vector<double>& times = list_.times;
  const double time = scan_times_[index];
  if (time < times.front() - kMostBesides_s || time > times.back() + kMostBesides_s)
    throw Error({.file = times_path_,
                 .line = index + 1,
                 .expected = fmt::format("a time within the poses of {}, from {} to {} s",
                                         path_.string(), times.front(), times.back()),
                 .got = fmt::format("{} s", time),
                 .remedy = "use poses of the whole sequence in the clock of its times, or "
                           "--single-scan to do without"});
  const auto later = std::upper_bound(times.begin(), times.end(), time);
  if (later == times.begin()) return list_.poses.front();
  if (later == times.end()) return list_.poses.back();
  const auto next = static_cast<std::size_t>(later - times.begin());
  const double share = (time - times[next - 1]) / (times[next] - times[next - 1]);
  return between(list_.poses[next - 1], list_.poses[next], share);
}

}  // namespace groundgrid::io
