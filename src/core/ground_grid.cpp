#include "groundgrid/ground_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>
#include <vector>

#include "core/input_checks.hpp"
#include "core/map/elevation_map.hpp"
#include "core/method/constants.hpp"
#include "core/method/paper_method.hpp"
#include "core/method/reference_method.hpp"
#include "core/method/standard_method.hpp"
#include "core/parallel.hpp"

namespace groundgrid {
namespace {

/// Below this cosine of its tilt a base plane says nothing about the ground around it.
constexpr double kMinUpright = 0.5;

Eigen::Isometry3d mounting_of(const SensorScan& scan) {
  return scan.T_base_sensor ? scan.T_base_sensor->isometry() : Eigen::Isometry3d::Identity();
}

/// The plane on which a vehicle at this pose stands; base's z axis meets it `ground_z` above base.
Plane ground_plane(const Eigen::Isometry3d& T_map_base, double ground_z) {
  const Eigen::Vector3d position = T_map_base.translation();
  const Eigen::Vector3d up = T_map_base.linear().col(2);
  Plane plane{position.x(), position.y(), position.z(), 0.0, 0.0, ground_z};
  if (up.z() < kMinUpright) return plane;
  plane.slope_x = -up.x() / up.z();
  plane.slope_y = -up.y() / up.z();
  // Straight below base, not along its z axis.
  plane.offset = ground_z / up.z();
  return plane;
}

}  // namespace

/// What a scan needs around the method: checks, the height of the sensor, the place of the map,
/// output.
class GroundGrid::Pipeline {
 public:
  Pipeline(const Config& config, TileRunner runner)
      : config_(checked(config)),
        runner_(std::move(runner)),
        map_(config),
        grid_(map_.cells()),
        standard_(map_, runner_),
        is_known_(map_.cells()) {}

  ScanResult process(const ScanRequest& request);

  void reset() {
    map_.reset();
    estimated_height_.reset();
    sensor_height_.reset();
    last_position_.reset();
    ground_z_ = 0.0;
  }

  [[nodiscard]] TerrainView terrain() const;
  std::span<const float> standard_deviation() {
    if (!map_.started()) return {};
    if (config_.method == Method::standard) return standard_.standard_deviation(map_);
    // The reference marks all cells that it knows.
    constexpr float kNoOther = 2.0F;
    return standard_.standard_deviation(
        is_known_, config_.method == Method::paper ? constants::kRemembered : kNoOther,
        plane_in_window(), map_);
  }
  [[nodiscard]] const Config& config() const { return config_; }

 private:
  static const Config& checked(const Config& config) {
    config.validate();
    return config;
  }
  double find_ground(std::span<const SensorScan> scans);
  bool place_map(const Eigen::Isometry3d& T_map_base);
  void place_sensors(std::span<const SensorScan> scans, const Motion& motion);
  [[nodiscard]] Eigen::Isometry3d to_window(const Eigen::Isometry3d& T_map_base) const;
  void choose_output(std::size_t points, const std::optional<ScanOutput>& output);
  std::optional<LabelCounts> run_method();
  [[nodiscard]] LocalPlane plane_in_window() const;

  Config config_;
  TileRunner runner_;
  ElevationMap map_;
  Plane ground_plane_;
  ScanGrid grid_;
  StandardMethod standard_;
  std::vector<std::uint8_t> is_known_;  // ground cells (paper), or all that hold the surface up
  BinnedPoints bins_;
  std::vector<SensorPass> passes_;  // keeps the buffers of the most sensors there ever were
  std::size_t sensors_ = 0;         // how many of them this scan has
  std::vector<Point3f> positions_;  // of the sensors, in the window
  std::vector<Label> label_buffer_;
  std::vector<float> height_buffer_;
  std::span<Label> labels_;
  std::span<float> height_above_ground_;
  std::optional<double> estimated_height_;
  std::optional<Eigen::Vector3d> last_position_;
  std::optional<double> sensor_height_;  // in use
  bool height_estimated_ = false;
  double ground_z_ = 0.0;  // height of the ground plane in base
  bool ground_known_ = false;
  bool half_done_ = false;  // true for good where an executor threw
};

ScanResult GroundGrid::Pipeline::process(const ScanRequest& request) {
  if (half_done_)
    throw std::logic_error("GroundGrid: an earlier scan failed half-way; make a new object");
  const std::span<const SensorScan> scans = request.scans;
  const Eigen::Isometry3d end = request.T_map_base.isometry();
  const Eigen::Isometry3d begin =
      request.T_map_base_begin ? request.T_map_base_begin->isometry() : end;
  const Motion motion{begin, end, request.T_map_base_begin.has_value()};
  check_input(scans, motion);
  std::size_t points = 0;
  for (const SensorScan& scan : scans) points += scan.points.count;
  choose_output(points, request.output);
  bins_.resize(points);
  positions_.resize(scans.size());
  if (passes_.size() < scans.size()) passes_.resize(scans.size());
  sensors_ = scans.size();

  // Nothing of ours fails from here on: a call either has no effect on the map or all of it.
  half_done_ = true;
  ScanResult result;
  ground_z_ = find_ground(scans);
  result.sensor_height_m = sensor_height_;
  result.sensor_height_estimated = sensor_height_ && height_estimated_;
  result.map_restarted = place_map(motion.T_map_base_end);
  place_sensors(scans, motion);
  std::optional<LabelCounts> counts = run_method();
  if (!counts) {
    // The ground is not where the map has it. A new map cannot contradict.
    map_.start(ground_plane_);
    result.map_restarted = true;
    place_sensors(scans, motion);
    counts = run_method();
  }
  result.ground = counts->ground;
  result.obstacle = counts->obstacle;
  result.outlier = counts->outlier;
  result.unknown = counts->unknown;
  result.labels = labels_;
  result.height_above_ground = height_above_ground_;
  half_done_ = false;
  return result;
}

void GroundGrid::Pipeline::choose_output(std::size_t points,
                                         const std::optional<ScanOutput>& output) {
  if (output) {
    if (output->labels.size() != points || output->height_above_ground.size() != points)
      throw std::invalid_argument("ScanOutput: its spans must have one element per point");
    labels_ = output->labels;
    height_above_ground_ = output->height_above_ground;
    return;
  }
  label_buffer_.resize(points);
  height_buffer_.resize(points);
  labels_ = label_buffer_;
  height_above_ground_ = height_buffer_;
}

double GroundGrid::Pipeline::find_ground(std::span<const SensorScan> scans) {
  ground_known_ = true;
  if (scans.empty()) {
    // Nothing new: what was known before stays, and a first scan is still to come.
    ground_known_ = last_position_.has_value();
    return ground_z_;
  }
  const SensorScan& first = scans.front();
  height_estimated_ = !config_.vehicle.sensor_height_m && !first.T_base_sensor;
  const double mounting_z = mounting_of(first).translation().z();
  if (config_.vehicle.sensor_height_m) {
    sensor_height_ = config_.vehicle.sensor_height_m;
    return mounting_z - *sensor_height_;
  }
  if (first.T_base_sensor) {
    sensor_height_ = mounting_z;
    return 0.0;
  }
  // A scan that shows no ground fixes nothing: the next one gets its chance.
  if (!estimated_height_) estimated_height_ = estimate_sensor_height(first.points, config_);
  sensor_height_ = estimated_height_;
  ground_known_ = sensor_height_.has_value();
  return -sensor_height_.value_or(0.0);
}

/// True where the pose jumped and the map was started anew.
bool GroundGrid::Pipeline::place_map(const Eigen::Isometry3d& T_map_base) {
  ground_plane_ = ground_plane(T_map_base, ground_z_);
  const Eigen::Vector3d position = T_map_base.translation();
  const bool jumped = last_position_ && !((position - *last_position_).norm() <= kPoseJump_m);
  if (jumped || !last_position_)
    map_.start(ground_plane_);
  else
    map_.follow(ground_plane_);
  if (ground_known_) last_position_ = position;
  return jumped;
}

Eigen::Isometry3d GroundGrid::Pipeline::to_window(const Eigen::Isometry3d& T_map_base) const {
  Eigen::Isometry3d T_window_base = T_map_base;
  const Eigen::Vector3d position = T_map_base.translation();
  T_window_base.translation() << map_.window_x(position.x()), map_.window_y(position.y()),
      map_.window_z(position.z());
  return T_window_base;
}

void GroundGrid::Pipeline::place_sensors(std::span<const SensorScan> scans, const Motion& motion) {
  const Eigen::Isometry3d T_window_begin = to_window(motion.T_map_base_begin);
  const Eigen::Isometry3d T_window_end = to_window(motion.T_map_base_end);
  std::size_t first = 0;
  for (std::size_t i = 0; i < scans.size(); ++i) {
    const Eigen::Isometry3d T_base_sensor = mounting_of(scans[i]);
    SensorPass& pass = passes_[i];
    pass.points = scans[i].points;
    pass.first = first;
    pass.T_base_sensor = PointTransform(T_base_sensor);
    if (motion.within_scan && scans[i].points.time_offset)
      pass.trajectory.set_moving(T_window_begin, T_window_end, T_base_sensor, scans[i].time_begin,
                                 scans[i].time_end);
    else
      pass.trajectory.set_fixed(T_window_end * T_base_sensor);
    positions_[i] = pass.trajectory.end().origin();
    first += scans[i].points.count;
  }
}

LocalPlane GroundGrid::Pipeline::plane_in_window() const {
  return {map_.window_z(ground_plane_.z) + ground_plane_.offset, ground_plane_.slope_x,
          ground_plane_.slope_y};
}

std::optional<LabelCounts> GroundGrid::Pipeline::run_method() {
  const Scan scan{std::span(passes_).first(sensors_), positions_, plane_in_window()};
  const Answers answers{labels_, height_above_ground_};
  switch (config_.method) {
    case Method::paper:
      return paper::process(scan, config_, bins_, grid_, is_known_, map_, answers);
    case Method::reference:
      return reference::process(scan, config_, bins_, grid_, is_known_, map_, answers);
    case Method::standard:
      break;
  }
  return standard_.process(scan, config_, bins_, grid_, map_, answers);
}

TerrainView GroundGrid::Pipeline::terrain() const {
  TerrainView view;
  if (!map_.started()) return view;
  view.size = map_.size();
  view.resolution_m = map_.cell_size();
  view.min_x_m = map_.min_x();
  view.min_y_m = map_.min_y();
  view.z_origin_m = map_.z_origin();
  view.relative_height = map_.height();
  view.confidence = map_.confidence();
  view.statistics = grid_.statistics.data();
  return view;
}

GroundGrid::GroundGrid(const Config& config, int threads)
    : pipeline_(std::make_unique<Pipeline>(config, TileRunner(threads))) {}
GroundGrid::GroundGrid(const Config& config, Executor& executor)
    : pipeline_(std::make_unique<Pipeline>(config, TileRunner(executor))) {}
GroundGrid::~GroundGrid() = default;
GroundGrid::GroundGrid(GroundGrid&&) noexcept = default;
GroundGrid& GroundGrid::operator=(GroundGrid&&) noexcept = default;

ScanResult GroundGrid::process(const SensorScan& scan, const Eigen::Isometry3d& T_map_base) {
  return process({.scans = std::span(&scan, 1), .T_map_base = T_map_base});
}

ScanResult GroundGrid::process(const ScanRequest& request) { return pipeline_->process(request); }

void GroundGrid::reset() { pipeline_->reset(); }
TerrainView GroundGrid::terrain() const { return pipeline_->terrain(); }
std::span<const float> GroundGrid::standard_deviation() const {
  return pipeline_->standard_deviation();
}
const Config& GroundGrid::config() const { return pipeline_->config(); }

}  // namespace groundgrid
