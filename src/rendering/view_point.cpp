#include "rendering/view_point.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace groundgrid::rendering {
namespace {

constexpr double kRadiansPerDegree = std::numbers::pi / 180.0;

// Straight down there is no upward direction.
constexpr double kSteepest_deg = 89.5;

// What the box takes of the width and height of the picture.
constexpr double kFilled = 0.94;

/// What places take of the picture, from -1 to 1 where they are on it.
struct Extent {
  Eigen::Vector2d low = Eigen::Vector2d::Constant(1e9);
  Eigen::Vector2d high = Eigen::Vector2d::Constant(-1e9);

  [[nodiscard]] bool fits() const { return (high - low).maxCoeff() <= 2.0 * kFilled; }
};

using Places = std::span<const Eigen::Vector3d>;

Extent extent_of(const Camera& camera, Places places, double aspect) {
  const Eigen::Matrix4d projection = projection_of(camera, aspect);
  Extent extent;
  for (const Eigen::Vector3d& place : places) {
    const Eigen::Vector4d seen = projection * place.homogeneous();
    // Behind the eye: it is far too near.
    if (seen.w() <= 0.0) return {Eigen::Vector2d::Constant(-1e9), Eigen::Vector2d::Constant(1e9)};
    const Eigen::Vector2d on_picture = seen.head<2>() / seen.w();
    extent.low = extent.low.cwiseMin(on_picture);
    extent.high = extent.high.cwiseMax(on_picture);
  }
  return extent;
}

Camera moved_to(const Camera& camera, double distance_m) {
  Camera moved = camera;
  moved.eye = camera.target + (camera.eye - camera.target).normalized() * distance_m;
  return moved;
}

Camera at_fitting_distance(const Camera& camera, Places places, double farthest, double aspect) {
  double near = 0.0;
  double far = farthest;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (near + far);
    const bool fits = extent_of(moved_to(camera, middle), places, aspect).fits();
    (fits ? far : near) = middle;
  }
  return moved_to(camera, far);
}

Camera aimed(const Camera& camera, const Extent& extent, double aspect) {
  const Eigen::Vector3d back = camera.eye - camera.target;
  const double tangent = std::tan(0.5 * camera.vertical_field_deg * kRadiansPerDegree);
  const Eigen::Vector3d right = Eigen::Vector3d::UnitZ().cross(back).normalized();
  const Eigen::Vector3d up = back.normalized().cross(right);
  const Eigen::Vector2d middle = 0.5 * (extent.low + extent.high);
  const Eigen::Vector3d shift =
      back.norm() * tangent * (aspect * middle.x() * right + middle.y() * up);
  Camera moved = camera;
  moved.eye += shift;
  moved.target += shift;
  return moved;
}

}  // namespace

Camera camera_at(const ViewPoint& view, const Eigen::Vector3d& target,
                 const Eigen::Vector3d& ahead) {
  const double elevation = std::min(view.elevation_deg, kSteepest_deg) * kRadiansPerDegree;
  const Eigen::Vector3d level =
      Eigen::AngleAxisd(view.azimuth_deg * kRadiansPerDegree, Eigen::Vector3d::UnitZ()) * ahead;
  const Eigen::Vector3d back =
      -std::cos(elevation) * level + std::sin(elevation) * Eigen::Vector3d::UnitZ();
  return {.eye = target + view.distance_m * back, .target = target};
}

Camera camera_around(const ViewPoint& view, Places places, const Eigen::Vector3d& ahead,
                     double aspect) {
  Eigen::Vector3d low = places.front();
  Eigen::Vector3d high = places.front();
  for (const Eigen::Vector3d& place : places) {
    low = low.cwiseMin(place);
    high = high.cwiseMax(place);
  }
  const double size_m = std::max((high - low).norm(), 1.0);
  ViewPoint somewhere = view;
  if (view.distance_m <= 0.0) somewhere.distance_m = size_m;
  Camera camera = camera_at(somewhere, 0.5 * (low + high), ahead);
  if (view.distance_m > 0.0) return camera;
  // Aiming changes what fits, and the distance what is in the middle, less and less so.
  constexpr int kSteps = 4;
  for (int i = 0; i < kSteps; ++i) {
    camera = at_fitting_distance(camera, places, 20.0 * size_m, aspect);
    camera = aimed(camera, extent_of(camera, places, aspect), aspect);
  }
  return camera;
}

PixelPoint place_on(const Rectangle& plot, const Camera& camera, const Eigen::Vector3d& place) {
  const Eigen::Vector4d seen =
      projection_of(camera, plot.width / plot.height) * place.homogeneous();
  if (seen.w() <= 0.0) return {-1.0, -1.0};
  return {plot.x + plot.width * 0.5 * (1.0 + seen.x() / seen.w()),
          plot.y + plot.height * 0.5 * (1.0 - seen.y() / seen.w())};
}

}  // namespace groundgrid::rendering
