#include "groundgrid/ground_grid.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/cell_limits.hpp"
#include "core/elevation_map.hpp"
#include "core/ground_cells.hpp"
#include "core/ground_elevation.hpp"
#include "core/ground_envelope.hpp"
#include "core/interpolation.hpp"
#include "core/outlier_filter.hpp"
#include "core/parallel.hpp"
#include "core/rasterization.hpp"
#include "core/segmentation.hpp"

namespace groundgrid {
namespace {

/// Below this cosine of its tilt a base plane says nothing about the ground around it.
constexpr double kMinUpright = 0.5;
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
    throw std::invalid_argument(std::string("PointView: the offset of ") + name +
                                " does not fit into stride_bytes");
}

void check_view(const PointView& view) {
  if (view.count == 0) return;
  if (view.data == nullptr) throw std::invalid_argument("PointView: data is null");
  check_offset(view, view.x_offset, sizeof(float), "x");
  check_offset(view, view.y_offset, sizeof(float), "y");
  check_offset(view, view.z_offset, sizeof(float), "z");
  if (view.time_offset) check_offset(view, *view.time_offset, size_of(view.time_type), "time");
}

Eigen::Isometry3d mounting_of(const SensorScan& scan) {
  return scan.T_base_sensor ? scan.T_base_sensor->isometry() : Eigen::Isometry3d::Identity();
}

/// Where base was while the scan was taken.
struct Motion {
  const Eigen::Isometry3d& T_map_base_begin;
  const Eigen::Isometry3d& T_map_base_end;
  bool within_scan;  ///< Whether points with times are to be corrected for the way between.
};

/// The plane on which a vehicle at this pose stands, `ground_z` above base's origin.
Plane ground_plane(const Eigen::Isometry3d& T_map_base, double ground_z) {
  const Eigen::Vector3d up = T_map_base.linear().col(2);
  const Eigen::Vector3d contact = T_map_base.translation() + ground_z * up;
  Plane plane{contact.x(), contact.y(), contact.z(), 0.0, 0.0};
  if (up.z() >= kMinUpright) {
    plane.slope_x = -up.x() / up.z();
    plane.slope_y = -up.y() / up.z();
  }
  return plane;
}

}  // namespace

/// The stages of the paper in their order, and the buffers they share.
class GroundGrid::Pipeline {
 public:
  explicit Pipeline(const Config& config)
      : config_(checked(config)),
        runner_(config.threads),
        map_(config),
        grid_(map_.cells()),
        ground_cells_(map_.cells()),
        envelope_(map_),
        limits_(map_.cells()) {}

  ScanResult process(std::span<const SensorScan> scans, const Motion& motion,
                     const ScanOutput* output);

  void reset() {
    map_.reset();
    estimated_height_.reset();
    last_position_.reset();
  }

  [[nodiscard]] TerrainView terrain() const;
  [[nodiscard]] const Config& config() const { return config_; }

 private:
  static const Config& checked(const Config& config) {
    config.validate();
    return config;
  }
  static void check_input(std::span<const SensorScan> scans, const Motion& motion);
  double ground_below_base(std::span<const SensorScan> scans, ScanResult& result);
  void place_map(const Eigen::Isometry3d& T_map_base, double ground_z, ScanResult& result);
  void place_sensors(std::span<const SensorScan> scans, const Motion& motion);
  [[nodiscard]] Eigen::Isometry3d to_window(const Eigen::Isometry3d& T_map_base) const;
  void choose_output(std::size_t points, const ScanOutput* output);
  void run_stages();
  void count_labels(ScanResult& result) const;

  Config config_;
  TileRunner runner_;
  ElevationMap map_;
  Plane ground_plane_;
  ScanGrid grid_;
  GroundCells ground_cells_;
  GroundEnvelope envelope_;
  CellLimits limits_;
  BinnedPoints bins_;
  std::vector<SensorPass> passes_;
  SensorPositions positions_;
  std::vector<Label> label_buffer_;
  std::vector<float> height_buffer_;
  std::span<Label> labels_;
  std::span<float> height_above_ground_;
  std::optional<double> estimated_height_;
  std::optional<Eigen::Vector3d> last_position_;
  bool height_known_ = false;
};

ScanResult GroundGrid::Pipeline::process(std::span<const SensorScan> scans, const Motion& motion,
                                         const ScanOutput* output) {
  check_input(scans, motion);
  std::size_t points = 0;
  for (const SensorScan& scan : scans) points += scan.points.count;
  choose_output(points, output);

  ScanResult result;
  const double ground_z = ground_below_base(scans, result);
  place_map(motion.T_map_base_end, ground_z, result);
  place_sensors(scans, motion);
  bins_.resize(points);
  run_stages();
  count_labels(result);
  result.labels = labels_;
  result.height_above_ground = height_above_ground_;
  return result;
}

void GroundGrid::Pipeline::check_input(std::span<const SensorScan> scans, const Motion& motion) {
  check_pose(motion.T_map_base_begin, "T_map_base_begin");
  check_pose(motion.T_map_base_end, "T_map_base_end");
  for (const SensorScan& scan : scans) {
    check_view(scan.points);
    if (scan.T_base_sensor) check_pose(scan.T_base_sensor->isometry(), "T_base_sensor");
    if (motion.within_scan && scan.points.time_offset && !(scan.time_end > scan.time_begin))
      throw std::invalid_argument("SensorScan: time_end must be later than time_begin");
  }
}

void GroundGrid::Pipeline::choose_output(std::size_t points, const ScanOutput* output) {
  if (output != nullptr) {
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

double GroundGrid::Pipeline::ground_below_base(std::span<const SensorScan> scans,
                                               ScanResult& result) {
  height_known_ = true;
  if (scans.empty()) return 0.0;
  const SensorScan& first = scans.front();
  const double mounting_z = mounting_of(first).translation().z();
  if (config_.sensor_height_m) {
    result.sensor_height_m = *config_.sensor_height_m;
    return mounting_z - *config_.sensor_height_m;
  }
  if (first.T_base_sensor) {
    result.sensor_height_m = mounting_z;
    return 0.0;
  }
  if (!estimated_height_) estimated_height_ = estimate_sensor_height(first.points);
  // A scan that shows no ground fixes nothing: the next one gets its chance.
  height_known_ = estimated_height_.has_value();
  result.sensor_height_estimated = height_known_;
  result.sensor_height_m = estimated_height_.value_or(0.0);
  return -result.sensor_height_m;
}

void GroundGrid::Pipeline::place_map(const Eigen::Isometry3d& T_map_base, double ground_z,
                                     ScanResult& result) {
  const Plane ground = ground_plane(T_map_base, ground_z);
  ground_plane_ = ground;
  const Eigen::Vector3d position = T_map_base.translation();
  const bool jumped =
      last_position_ && !((position - *last_position_).norm() <= config_.pose_jump_m);
  result.map_restarted = jumped;
  if (jumped || !last_position_)
    map_.start(ground);
  else
    map_.follow(ground);
  if (height_known_) last_position_ = position;
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
  passes_.resize(scans.size());
  positions_.sensors.clear();
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
    positions_.sensors.push_back(pass.trajectory.end().origin());
    first += scans[i].points.count;
  }
}

void GroundGrid::Pipeline::run_stages() {
  for (const SensorPass& pass : passes_) {
    bin_points(pass, map_, config_, runner_, bins_);
    filter_outliers(pass, map_, config_, bins_, runner_, labels_);
  }
  rasterize(bins_, labels_, runner_, grid_);
  ground_cells_.classify(grid_, map_, positions_, config_, runner_);
  if (config_.reject_raised)
    envelope_.reject_raised(grid_, map_, ground_plane_, config_, ground_cells_);
  update_elevation(grid_, ground_cells_, config_, runner_, map_);
  const Point3f centre = positions_.sensors.empty() ? Point3f{} : positions_.sensors.front();
  interpolate(ground_cells_.is_ground(), map_.nearest_cell(centre.x), map_.nearest_cell(centre.y),
              config_, map_);
  if (config_.threshold_by_column)
    limits_.choose_by_column(bins_, labels_, grid_, map_, config_, runner_);
  else
    limits_.choose_by_class(grid_, ground_cells_.is_ground(), map_, config_);
  segment(bins_, limits_, map_, runner_, labels_, height_above_ground_);
}

void GroundGrid::Pipeline::count_labels(ScanResult& result) const {
  std::size_t counts[4] = {0, 0, 0, 0};
  for (const Label label : labels_) ++counts[static_cast<std::size_t>(label)];
  result.unknown = counts[static_cast<std::size_t>(Label::unknown)];
  result.ground = counts[static_cast<std::size_t>(Label::ground)];
  result.obstacle = counts[static_cast<std::size_t>(Label::obstacle)];
  result.outlier = counts[static_cast<std::size_t>(Label::outlier)];
}

TerrainView GroundGrid::Pipeline::terrain() const {
  TerrainView view;
  if (!map_.started()) return view;
  view.size = map_.size();
  view.cell_size_m = map_.cell_size();
  view.min_x_m = map_.min_x();
  view.min_y_m = map_.min_y();
  view.z_origin_m = map_.z_origin();
  view.relative_height = map_.height();
  view.confidence = map_.confidence();
  view.statistics = grid_.statistics;
  return view;
}

GroundGrid::GroundGrid(const Config& config) : pipeline_(std::make_unique<Pipeline>(config)) {}
GroundGrid::~GroundGrid() = default;
GroundGrid::GroundGrid(GroundGrid&&) noexcept = default;
GroundGrid& GroundGrid::operator=(GroundGrid&&) noexcept = default;

ScanResult GroundGrid::process(const SensorScan& scan, const Eigen::Isometry3d& T_map_base) {
  return process(std::span(&scan, 1), T_map_base);
}

ScanResult GroundGrid::process(std::span<const SensorScan> scans,
                               const Eigen::Isometry3d& T_map_base) {
  return pipeline_->process(scans, {T_map_base, T_map_base, false}, nullptr);
}

ScanResult GroundGrid::process(std::span<const SensorScan> scans,
                               const Eigen::Isometry3d& T_map_base_begin,
                               const Eigen::Isometry3d& T_map_base_end) {
  return pipeline_->process(scans, {T_map_base_begin, T_map_base_end, true}, nullptr);
}

ScanResult GroundGrid::process(std::span<const SensorScan> scans,
                               const Eigen::Isometry3d& T_map_base_begin,
                               const Eigen::Isometry3d& T_map_base_end, const ScanOutput& output) {
  return pipeline_->process(scans, {T_map_base_begin, T_map_base_end, true}, &output);
}

void GroundGrid::reset() { pipeline_->reset(); }
TerrainView GroundGrid::terrain() const { return pipeline_->terrain(); }
const Config& GroundGrid::config() const { return pipeline_->config(); }

}  // namespace groundgrid
