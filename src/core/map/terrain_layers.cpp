// The map's layers for planners. Not in the paper.
#include "groundgrid/terrain_layers.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/map/cell_statistics.hpp"
#include "core/point_transform.hpp"

namespace groundgrid {
namespace {

constexpr float kNothing = std::numeric_limits<float>::quiet_NaN();
constexpr double kMostWindow_m = 100.0;
// The sides of a step are next to its cell; how steep they are shows two cells further on.
constexpr int kBesideStep = 1;
constexpr int kBeyondStep = 3;

std::size_t cells_of(const TerrainView& terrain) {
  return static_cast<std::size_t>(terrain.size) * static_cast<std::size_t>(terrain.size);
}

void check_layers_input(const TerrainView& terrain) {
  const std::size_t cells = terrain.size < 0 ? 0 : cells_of(terrain);
  if (terrain.size < 0 || terrain.relative_height.size() != cells ||
      terrain.confidence.size() != cells || (cells > 0 && terrain.statistics == nullptr))
    throw std::invalid_argument("TerrainLayers: every layer must have size x size cells");
  if (terrain.size > 0 && !(terrain.resolution_m > 0.0))
    throw std::invalid_argument("TerrainLayers: resolution_m must be positive");
}

/// Highest return below the clearance as far as the cell's extremes tell; NaN where they do not.
float obstacle_from(const CellStatistics& points, float ground,
                    const TraversabilityLimits& limits) {
  if (points.count == 0) return kNothing;
  const double above = points.max * CellStatistics::kStep_m - static_cast<double>(ground);
  return above < limits.overhang_clearance_m ? static_cast<float>(above) : kNothing;
}

/// A plane by least squares from sums over known cells, x and y in cells.
struct PlaneSums {
  double n = 0.0, x = 0.0, y = 0.0, z = 0.0;
  double xx = 0.0, xy = 0.0, yy = 0.0, xz = 0.0, yz = 0.0, zz = 0.0;

  void add(double at_x, double at_y, double height) {
    n += 1.0;
    x += at_x;
    y += at_y;
    z += height;
    xx += at_x * at_x;
    xy += at_x * at_y;
    yy += at_y * at_y;
    xz += at_x * height;
    yz += at_y * height;
    zz += height * height;
  }
};

}  // namespace

void TraversabilityLimits::validate() const {
  const auto check = [](const char* name, double value) {
    if (!std::isfinite(value) || value < 0.0)
      throw std::invalid_argument("TraversabilityLimits: " + std::string(name) +
                                  " must be finite and not negative");
  };
  check("max_slope_deg", max_slope_deg);
  check("max_step_m", max_step_m);
  check("max_roughness_m", max_roughness_m);
  check("min_obstacle_height_m", min_obstacle_height_m);
  check("overhang_clearance_m", overhang_clearance_m);
  check("min_confidence", min_confidence);
}

/// Buffers and what fills them.
class TerrainLayers::Layers {
 public:
  explicit Layers(double window_m) : window_m_(window_m) {
    if (!(window_m > 0.0 && window_m <= kMostWindow_m))
      throw std::invalid_argument("TerrainLayers: window_m must be above 0 and at most 100");
  }

  void begin(const TerrainView& terrain, const TraversabilityLimits& limits);
  void find_ground_layers(const TerrainView& terrain);
  void find_obstacles(const TerrainView& terrain, const TraversabilityLimits& limits);
  void find_obstacles(const TerrainView& terrain, std::span<const SensorScan> scans,
                      const Eigen::Isometry3d& T_map_base, std::span<const Label> labels,
                      const TraversabilityLimits& limits);
  void judge(const TraversabilityLimits& limits);

  [[nodiscard]] int size() const { return size_; }
  [[nodiscard]] std::span<const float> slope_deg() const { return slope_deg_; }
  [[nodiscard]] std::span<const float> step_m() const { return step_m_; }
  [[nodiscard]] std::span<const float> roughness_m() const { return roughness_m_; }
  [[nodiscard]] std::span<const float> obstacle_height_m() const { return obstacle_height_m_; }
  [[nodiscard]] std::span<const Traversability> traversability() const { return traversability_; }

 private:
  struct Plane {
    double slope_x;
    double slope_y;
    double roughness_m;
  };

  [[nodiscard]] Plane fit_plane(const TerrainView& terrain, int column, int row) const;
  [[nodiscard]] float height_at(int column, int row) const;
  [[nodiscard]] float step_at(int column, int row, const Plane& plane, double resolution_m) const;

  double window_m_;
  int size_ = 0;
  int reach_ = 1;              // cells of the window on each side of its middle
  std::vector<float> height_;  // of known cells; NaN
  std::vector<float> slope_deg_;
  std::vector<float> step_m_;
  std::vector<float> roughness_m_;
  std::vector<float> obstacle_height_m_;
  std::vector<Traversability> traversability_;
};

void TerrainLayers::Layers::begin(const TerrainView& terrain, const TraversabilityLimits& limits) {
  limits.validate();
  check_layers_input(terrain);
  size_ = terrain.size;
  const double side = size_ > 0 ? window_m_ / terrain.resolution_m : 0.0;
  reach_ = std::max(1, static_cast<int>(std::lround(std::min(side, 2.0 * size_) - 1.0) / 2));
  const std::size_t cells = cells_of(terrain);
  for (std::vector<float>* layer :
       {&height_, &slope_deg_, &step_m_, &roughness_m_, &obstacle_height_m_})
    layer->assign(cells, kNothing);
  traversability_.assign(cells, Traversability::unknown);
  // A cell without confidence is unknown whatever the limit.
  for (std::size_t cell = 0; cell < cells; ++cell) {
    const auto confidence = static_cast<double>(terrain.confidence[cell]);
    if (confidence > 0.0 && confidence >= limits.min_confidence)
      height_[cell] = terrain.relative_height[cell];
  }
}

float TerrainLayers::Layers::height_at(int column, int row) const {
  if (column < 0 || row < 0 || column >= size_ || row >= size_) return kNothing;
  return height_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
                 static_cast<std::size_t>(column)];
}

TerrainLayers::Layers::Plane TerrainLayers::Layers::fit_plane(const TerrainView& terrain,
                                                              int column, int row) const {
  constexpr Plane kNoPlane{static_cast<double>(kNothing), static_cast<double>(kNothing),
                           static_cast<double>(kNothing)};
  // From the middle's height, so that the squares stay small.
  const auto middle = static_cast<double>(height_at(column, row));
  PlaneSums sums;
  for (int y = -reach_; y <= reach_; ++y) {
    for (int x = -reach_; x <= reach_; ++x) {
      const float height = height_at(column + x, row + y);
      if (!std::isnan(height)) sums.add(x, y, static_cast<double>(height) - middle);
    }
  }
  const double window = (2.0 * reach_ + 1.0) * (2.0 * reach_ + 1.0);
  if (sums.n < 0.5 * window) return kNoPlane;
  const double xx = sums.xx - sums.x * sums.x / sums.n;
  const double xy = sums.xy - sums.x * sums.y / sums.n;
  const double yy = sums.yy - sums.y * sums.y / sums.n;
  const double xz = sums.xz - sums.x * sums.z / sums.n;
  const double yz = sums.yz - sums.y * sums.z / sums.n;
  const double zz = sums.zz - sums.z * sums.z / sums.n;
  // More than half of a square never lies on one line.
  const double determinant = xx * yy - xy * xy;
  const double slope_x = (xz * yy - yz * xy) / determinant;
  const double slope_y = (yz * xx - xz * xy) / determinant;
  const double residuals = std::max(zz - slope_x * xz - slope_y * yz, 0.0);
  return {slope_x / terrain.resolution_m, slope_y / terrain.resolution_m,
          std::sqrt(residuals / sums.n)};
}

float TerrainLayers::Layers::step_at(int column, int row, const Plane& plane,
                                     double resolution_m) const {
  constexpr std::array<std::array<int, 2>, 4> kDirections{{{1, 0}, {1, 1}, {0, 1}, {-1, 1}}};
  float highest = kNothing;
  for (const auto& [x, y] : kDirections) {
    const auto height = [&, x = x, y = y](int away) {
      return height_at(column + away * x, row + away * y);
    };
    const float before = height(-kBesideStep);
    const float after = height(kBesideStep);
    const float rise = after - before;
    if (std::isnan(rise)) continue;
    const float slope_before = before - height(-kBeyondStep);
    const float slope_after = height(kBeyondStep) - after;
    float slope = 0.5F * (slope_before + slope_after);
    if (std::isnan(slope_after)) slope = slope_before;
    if (std::isnan(slope_before)) slope = slope_after;
    if (std::isnan(slope))
      slope = static_cast<float>((plane.slope_x * x + plane.slope_y * y) * 2.0 * kBesideStep *
                                 resolution_m);
    if (std::isnan(slope)) continue;
    const float along = rise < 0.0F ? -slope : slope;
    const float step = std::max(std::abs(rise) - std::max(along, 0.0F), 0.0F);
    if (!(step <= highest)) highest = step;
  }
  return highest;
}

void TerrainLayers::Layers::find_ground_layers(const TerrainView& terrain) {
  std::size_t cell = 0;
  for (int row = 0; row < size_; ++row) {
    for (int column = 0; column < size_; ++column, ++cell) {
      if (std::isnan(height_[cell])) continue;
      const Plane plane = fit_plane(terrain, column, row);
      slope_deg_[cell] = static_cast<float>(std::atan(std::hypot(plane.slope_x, plane.slope_y)) *
                                            180.0 / std::numbers::pi);
      roughness_m_[cell] = static_cast<float>(plane.roughness_m);
      step_m_[cell] = step_at(column, row, plane, terrain.resolution_m);
    }
  }
}

void TerrainLayers::Layers::find_obstacles(const TerrainView& terrain,
                                           const TraversabilityLimits& limits) {
  for (std::size_t cell = 0; cell < cells_of(terrain); ++cell)
    obstacle_height_m_[cell] =
        obstacle_from(terrain.statistics[cell], terrain.relative_height[cell], limits);
}

Traversability traversability_of(const CellLayers& cell, const TraversabilityLimits& limits) {
  // Written so that NaN passes no limit.
  const auto passes = [](float value, double limit) { return static_cast<double>(value) > limit; };
  if (static_cast<double>(cell.obstacle_height_m) >= limits.min_obstacle_height_m ||
      passes(cell.slope_deg, limits.max_slope_deg) || passes(cell.step_m, limits.max_step_m) ||
      passes(cell.roughness_m, limits.max_roughness_m))
    return Traversability::no;
  // There is a roughness where there is a slope.
  const bool known = !std::isnan(cell.slope_deg) && !std::isnan(cell.step_m);
  return known ? Traversability::yes : Traversability::unknown;
}

void TerrainLayers::Layers::judge(const TraversabilityLimits& limits) {
  for (std::size_t cell = 0; cell < traversability_.size(); ++cell) {
    float& obstacle = obstacle_height_m_[cell];
    traversability_[cell] =
        traversability_of({slope_deg_[cell], step_m_[cell], roughness_m_[cell], obstacle}, limits);
    if (static_cast<double>(obstacle) < limits.min_obstacle_height_m) obstacle = 0.0F;
  }
}

void TerrainLayers::Layers::find_obstacles(const TerrainView& terrain,
                                           std::span<const SensorScan> scans,
                                           const Eigen::Isometry3d& T_map_base,
                                           std::span<const Label> labels,
                                           const TraversabilityLimits& limits) {
  Eigen::Isometry3d T_view_base = T_map_base;
  T_view_base.translation() -=
      Eigen::Vector3d(terrain.min_x_m, terrain.min_y_m, terrain.z_origin_m);
  const auto clearance = static_cast<float>(limits.overhang_clearance_m);
  const double cells_per_m = size_ > 0 ? 1.0 / terrain.resolution_m : 0.0;
  const Label* label = labels.data();
  for (const SensorScan& scan : scans) {
    const PointTransform T_view_sensor(
        scan.T_base_sensor ? T_view_base * scan.T_base_sensor->isometry() : T_view_base);
    for (std::size_t i = 0; i < scan.points.count; ++i, ++label) {
      if (*label == Label::unknown || *label == Label::outlier) continue;
      const Point3f p = T_view_sensor.apply(load_point(scan.points, i));
      const double column = std::floor(static_cast<double>(p.x) * cells_per_m);
      const double row = std::floor(static_cast<double>(p.y) * cells_per_m);
      // Written so that NaN is outside.
      if (!(column >= 0.0 && row >= 0.0 && column < size_ && row < size_)) continue;
      const auto cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) +
                        static_cast<std::size_t>(column);
      const float above = p.z - terrain.relative_height[cell];
      float& highest = obstacle_height_m_[cell];
      if (above < clearance && !(above <= highest)) highest = above;
    }
  }
}

TerrainLayers::TerrainLayers(double window_m) : layers_(std::make_unique<Layers>(window_m)) {}
TerrainLayers::~TerrainLayers() = default;
TerrainLayers::TerrainLayers(TerrainLayers&&) noexcept = default;
TerrainLayers& TerrainLayers::operator=(TerrainLayers&&) noexcept = default;

void TerrainLayers::update(const TerrainView& terrain, const TraversabilityLimits& limits) {
  layers_->begin(terrain, limits);
  layers_->find_ground_layers(terrain);
  layers_->find_obstacles(terrain, limits);
  layers_->judge(limits);
}

void TerrainLayers::update(const TerrainView& terrain, std::span<const SensorScan> scans,
                           const Eigen::Isometry3d& T_map_base, std::span<const Label> labels,
                           const TraversabilityLimits& limits) {
  std::size_t points = 0;
  for (const SensorScan& scan : scans) {
    if (scan.points.count > 0 && scan.points.data == nullptr)
      throw std::invalid_argument("TerrainLayers: a view of points has no data");
    points += scan.points.count;
  }
  if (labels.size() != points)
    throw std::invalid_argument("TerrainLayers: there must be one label a point");
  layers_->begin(terrain, limits);
  layers_->find_ground_layers(terrain);
  layers_->find_obstacles(terrain, scans, T_map_base, labels, limits);
  layers_->judge(limits);
}

int TerrainLayers::size() const { return layers_->size(); }
std::span<const float> TerrainLayers::slope_deg() const { return layers_->slope_deg(); }
std::span<const float> TerrainLayers::step_m() const { return layers_->step_m(); }
std::span<const float> TerrainLayers::roughness_m() const { return layers_->roughness_m(); }
std::span<const float> TerrainLayers::obstacle_height_m() const {
  return layers_->obstacle_height_m();
}
std::span<const Traversability> TerrainLayers::traversability() const {
  return layers_->traversability();
}

}  // namespace groundgrid
