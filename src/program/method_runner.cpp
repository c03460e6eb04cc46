#include "program/method_runner.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <stdexcept>

#include "io/bin_scan.hpp"
#include "io/error.hpp"
#include "io/semantic_kitti_labels.hpp"

namespace groundgrid::program {
namespace {

std::optional<io::KittiPoses> poses_of(const io::ScanSequence& sequence, bool single_scan) {
  if (single_scan) return std::nullopt;
  if (!std::filesystem::exists(sequence.poses()))
    throw io::Error({.file = sequence.poses(),
                     .expected = "the poses of the sequence",
                     .got = "nothing of that name",
                     .remedy = "use --single-scan to do without poses"});
  return io::KittiPoses(sequence.poses(), sequence.calibration());
}

// What the library refuses (a pose out of all bounds) is a fault of this scan's input.
ScanResult process_scan(GroundGrid& grid, const SensorScan& sensor_scan,
                        const Eigen::Isometry3d& T_map_lidar, const io::ScanFile& scan) {
  try {
    return grid.process(sensor_scan, T_map_lidar);
  } catch (const std::invalid_argument& error) {
    throw io::Error(
        {.file = scan.path, .expected = "a scan and a pose to work with", .got = error.what()});
  }
}

}  // namespace

std::string SensorHeights::words() const {
  if (!estimated) return fmt::format("{:.2f} m above the ground, as given", greatest);
  const std::string low = fmt::format("{:.2f}", least);
  const std::string high = fmt::format("{:.2f}", greatest);
  if (low == high) return fmt::format("{} m above the ground, estimated", high);
  return fmt::format("{} to {} m above the ground, estimated scan by scan", low, high);
}

MethodRunner::MethodRunner(const Config& config, const io::ScanSequence& sequence, bool single_scan)
    : grid_(config), poses_(poses_of(sequence, single_scan || sequence.plain())) {}

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

  note_sensor_height(result);
  labels_.resize(count);
  std::transform(result.labels.begin(), result.labels.end(), labels_.begin(),
                 io::semantic_kitti_label);
  return {points_, labels_, result, time.count()};
}

void MethodRunner::note_sensor_height(const ScanResult& result) {
  const double height = result.sensor_height_m;
  if (!sensor_heights_) sensor_heights_ = {height, height, result.sensor_height_estimated};
  sensor_heights_->least = std::min(sensor_heights_->least, height);
  sensor_heights_->greatest = std::max(sensor_heights_->greatest, height);
}

}  // namespace groundgrid::program
