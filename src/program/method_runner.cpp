#include "program/method_runner.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <exception>
#include <new>
#include <numbers>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>

#include "io/error.hpp"
#include "io/semantic_kitti_labels.hpp"
#include "program/pose_frames.hpp"
#include "program/scan_reading.hpp"
#include "program/scan_summary.hpp"

namespace groundgrid::program {
namespace {

// The map, its statistics and what the stages keep for each cell, all together.
constexpr double kBytesPerCell = 150.0;

[[noreturn]] void fail_without_memory(const Config& config) {
  const double side = std::ceil(config.map.extent_m / config.map.resolution_m);
  throw std::runtime_error(fmt::format(
      "not enough memory: a map of {0:.0f} x {0:.0f} cells (extent_m = {1}, resolution_m = {2}) "
      "takes about {3:.0f} MB; choose a smaller --extent-m or a larger --resolution-m",
      side, config.map.extent_m, config.map.resolution_m, side * side * kBytesPerCell / 1e6));
}

GroundGrid make_grid(const Config& config, int threads) {
  try {
    return GroundGrid(config, threads);
  } catch (const std::bad_alloc&) {
    fail_without_memory(config);
  }
}

// What the library refuses (a pose out of all bounds) is a fault of this scan's input.
ScanResult process_scan(GroundGrid& grid, const SensorScan& sensor_scan,
                        const Eigen::Isometry3d& T_map_base, const io::ScanFile& scan) {
  try {
    return grid.process(sensor_scan, T_map_base);
  } catch (const std::invalid_argument& error) {
    throw io::Error(
        {.file = scan.path, .expected = "a scan and a pose to work with", .got = error.what()});
  } catch (const std::bad_alloc&) {
    fail_without_memory(grid.config());
  }
}

// No ground vehicle stands like that: the frame of the poses or the mounting is another one.
void require_upright(const Eigen::Isometry3d& T_map_base, const io::ScanFile& scan) {
  constexpr double kMostTilt_deg = 60.0;
  const double tilt_deg =
      std::acos(std::clamp(T_map_base.linear()(2, 2), -1.0, 1.0)) * 180.0 / std::numbers::pi;
  if (tilt_deg < kMostTilt_deg) return;
  throw io::Error({.file = scan.path,
                   .expected = "a pose that stands upright in a map whose z is up",
                   .got = fmt::format("one that leans by {:.0f} degrees", tilt_deg),
                   .remedy = "say how the LiDAR is mounted by --lidar-rpy-deg, or that the poses "
                             "are a camera's by --calibration"});
}

void warn_about(const io::ScanFile& scan, const ScanResult& result, const Config& config) {
  if (result.map_restarted)
    spdlog::warn(
        "{}: the map starts anew: its pose is more than {} m from the one before, or the ground is "
        "not where the map has it (a lift, or a pose that is wrong in height)",
        scan.path.string(), kPoseJump_m);
  if (result.unknown == result.labels.size())
    spdlog::warn(
        "{}: none of its {} points has a label; all are NaN, too near or outside of the {} m "
        "around the LiDAR (`groundgrid info` tells)",
        scan.path.string(), result.unknown, config.map.extent_m);
}

}  // namespace

MethodRunner::MethodRunner(const Config& config, int threads, std::optional<io::ScanPoses> poses,
                           RunFrames frames)
    : threads_(threads),
      grid_(make_grid(config, threads)),
      poses_(std::move(poses)),
      frames_(std::move(frames)),
      T_map_poses_(poses_ ? frames_.T_map_level * T_level_poses(*poses_, frames_.R_level_lidar)
                          : frames_.T_map_level) {}

void MethodRunner::read(const io::ScanFile& scan, ScanSlot& slot) const {
  read_into_slot(scan, frames_.R_level_lidar, slot);
}

Eigen::Isometry3d MethodRunner::pose(const io::ScanFile& scan) const {
  if (!poses_ || is_lone(scan)) return frames_.T_map_level;
  Eigen::Isometry3d T_lidar_level = Eigen::Isometry3d::Identity();
  T_lidar_level.linear() = frames_.R_level_lidar.transpose();
  Eigen::Isometry3d T_map_base = T_map_poses_ * poses_->pose(scan) * T_lidar_level;
  require_upright(T_map_base, scan);
  return T_map_base;
}

GroundGrid& MethodRunner::grid_for(const io::ScanFile& scan) {
  if (!is_lone(scan)) return grid_;
  if (!lone_grid_) lone_grid_.emplace(make_grid(grid_.config(), threads_));
  return *lone_grid_;
}

// What cannot be right shows in the first scan. It takes some milliseconds to see, so not in each.
void MethodRunner::warn_of_first(const io::ScanFile& scan, const ScanSlot& slot) {
  if (std::exchange(has_seen_first_, true)) return;
  const Config& config = grid_.config();
  ScanSummary summary = summary_of(scan, slot, config.map.extent_m);
  summary.viewpoint_remark.clear();
  if (config.vehicle.sensor_height_m) summary.sensor_height_m = config.vehicle.sensor_height_m;
  for (const std::string& remark : summary.remarks())
    spdlog::warn("{}: {}", scan.path.string(), remark);
}

void MethodRunner::warn_of_viewpoint(const io::ScanFile& scan, const io::PointCloud& cloud) {
  const std::string remark = has_warned_of_viewpoint_ ? "" : viewpoint_remark(cloud);
  if (remark.empty()) return;
  spdlog::warn("{}: {}", scan.path.string(), remark);
  has_warned_of_viewpoint_ = true;
}

void MethodRunner::process(const io::ScanFile& scan, ScanSlot& slot) {
  if (slot.problem) std::rethrow_exception(std::exchange(slot.problem, nullptr));
  warn_of_first(scan, slot);
  const Eigen::Isometry3d T_map_base = pose(scan);
  GroundGrid& grid = grid_for(scan);
  if (!poses_ || is_lone(scan)) grid.reset();
  const auto begin = std::chrono::steady_clock::now();
  const SensorScan sensor_scan{.points = slot.points};
  const ScanResult result = process_scan(grid, sensor_scan, T_map_base, scan);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;

  if (layers_ && !is_lone(scan))
    layers_->update(grid_.terrain(), std::span(&sensor_scan, 1), T_map_base, result.labels,
                    limits_);
  notes_.add(result);
  if (is_lone(scan)) ++notes_.without_pose;
  warn_about(scan, result, grid_.config());
  warn_of_viewpoint(scan, slot.cloud);
  slot.milliseconds = time.count();
  slot.counts = counts_of(result);
  slot.labels.resize(result.labels.size());
  std::transform(result.labels.begin(), result.labels.end(), slot.labels.begin(),
                 io::semantic_kitti_label);
  if (keeps_heights_)
    slot.height_above_ground.assign(result.height_above_ground.begin(),
                                    result.height_above_ground.end());
}

}  // namespace groundgrid::program
