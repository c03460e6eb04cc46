#include "program/method_runner.hpp"

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <utility>

#include "io/bin_scan.hpp"
#include "io/error.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::program {
namespace {

// The map, its statistics and what the stages keep for each cell, all together.
constexpr double kBytesPerCell = 150.0;

[[noreturn]] void fail_without_memory(const Config& config) {
  const double side = std::ceil(config.map_extent_m / config.cell_size_m);
  throw std::runtime_error(fmt::format(
      "not enough memory: a map of {0:.0f} x {0:.0f} cells (map_extent_m = {1}, cell_size_m = {2}) "
      "takes about {3:.0f} MB; choose a smaller --map-extent-m or a larger --cell-size-m",
      side, config.map_extent_m, config.cell_size_m, side * side * kBytesPerCell / 1e6));
}

GroundGrid make_grid(const Config& config) {
  try {
    return GroundGrid(config);
  } catch (const std::bad_alloc&) {
    fail_without_memory(config);
  }
}

// What the library refuses (a pose out of all bounds) is a fault of this scan's input.
ScanResult process_scan(GroundGrid& grid, const SensorScan& sensor_scan,
                        const Eigen::Isometry3d& T_map_lidar, const io::ScanFile& scan) {
  try {
    return grid.process(sensor_scan, T_map_lidar);
  } catch (const std::invalid_argument& error) {
    throw io::Error(
        {.file = scan.path, .expected = "a scan and a pose to work with", .got = error.what()});
  } catch (const std::bad_alloc&) {
    fail_without_memory(grid.config());
  }
}

}  // namespace

std::optional<io::KittiPoses> read_poses(const io::ScanSequence& sequence, bool single_scan) {
  if (single_scan || sequence.plain()) return std::nullopt;
  if (!std::filesystem::exists(sequence.poses()))
    throw io::Error({.file = sequence.poses(),
                     .expected = "the poses of the sequence",
                     .got = "nothing of that name",
                     .remedy = "use --single-scan to do without poses"});
  return io::KittiPoses(sequence.poses(), sequence.calibration());
}

std::optional<io::KittiPoses> read_every_pose(const io::ScanSequence& sequence, bool single_scan) {
  std::optional<io::KittiPoses> poses = read_poses(sequence, single_scan);
  // Scans are in the order of their numbers, so the last one needs the last line.
  if (poses) (void)poses->pose(sequence.scans.back().number);
  return poses;
}

MethodRunner::MethodRunner(const Config& config, std::optional<io::KittiPoses> poses)
    : grid_(make_grid(config)), poses_(std::move(poses)) {}

ProcessedScan MethodRunner::process(const io::ScanFile& scan) {
  io::read_bin_scan(scan.path, points_);
  const std::size_t count = points_.size() / io::kBinFloatsPerPoint;
  if (count == 0)
    throw io::Error(
        {.file = scan.path, .expected = "a scan", .got = "a file that holds no points"});
  const Eigen::Isometry3d T_map_lidar =
      poses_ ? poses_->pose(scan.number) : Eigen::Isometry3d::Identity();
  if (!poses_) grid_.reset();

  const SensorScan sensor_scan{
      .points = PointView::from_floats(points_.data(), count, io::kBinFloatsPerPoint)};
  const auto begin = std::chrono::steady_clock::now();
  const ScanResult result = process_scan(grid_, sensor_scan, T_map_lidar, scan);
  const std::chrono::duration<double, std::milli> time = std::chrono::steady_clock::now() - begin;

  notes_.add(result);
  if (result.map_restarted)
    spdlog::warn(
        "{}: its pose is more than pose_jump_m ({} m) from the one before; the map starts "
        "anew",
        scan.path.string(), grid_.config().pose_jump_m);
  labels_.resize(count);
  std::transform(result.labels.begin(), result.labels.end(), labels_.begin(),
                 io::semantic_kitti_label);
  return {points_, labels_, result, time.count()};
}

}  // namespace groundgrid::program
