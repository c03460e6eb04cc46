#include "simulation/drive.hpp"

#include <cmath>
#include <numbers>

#include "simulation/random.hpp"
#include "simulation/relief.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kFront_m = 1.4;
constexpr double kRear_m = -1.4;
constexpr double kHalfTrack_m = 0.75;
constexpr double kLevelFor_m = 1.0;
constexpr double kTiltedFrom_m = 12.0;

double wave(double time_s, double period_s, double phase) {
  return std::sin(2.0 * std::numbers::pi * time_s / period_s + phase);
}

}  // namespace

Drive::Drive(const Scene& scene, const Terrain& terrain, std::uint64_t seed)
    : scene_(&scene),
      terrain_(&terrain),
      phase_(Random(hash({seed, 2})).uniform(0.0, 2.0 * std::numbers::pi)) {}

Eigen::Isometry3d Drive::pose(double time_s) const {
  const double s = scene_->speed_mps * time_s;
  const double yaw = scene_->path->heading(s);
  const Eigen::Vector2d place = scene_->path->point({s, scene_->lane_m});
  const auto wheel = [&](double forward, double left) {
    return terrain_->height(place + Eigen::Rotation2Dd(yaw) * Eigen::Vector2d(forward, left));
  };
  const double front_left = wheel(kFront_m, kHalfTrack_m);
  const double front_right = wheel(kFront_m, -kHalfTrack_m);
  const double rear_left = wheel(kRear_m, kHalfTrack_m);
  const double rear_right = wheel(kRear_m, -kHalfTrack_m);
  const double climb = (front_left + front_right - rear_left - rear_right) / 2.0;
  const double lean = (front_left + rear_left - front_right - rear_right) / 2.0;
  const double share = smooth_step(kLevelFor_m, kTiltedFrom_m, s);
  const double pitch = -std::atan2(climb, kFront_m - kRear_m) + 0.005 * wave(time_s, 1.3, phase_);
  const double roll =
      std::atan2(lean, 2.0 * kHalfTrack_m) + 0.006 * wave(time_s, 1.7, 2.0 * phase_);
  const double height = (front_left + front_right + rear_left + rear_right) / 4.0 +
                        0.01 * share * wave(time_s, 1.1, 3.0 * phase_);
  return Eigen::Translation3d(place.x(), place.y(), height) *
         Eigen::AngleAxisd(yaw, Eigen::Vector3d::UnitZ()) *
         Eigen::AngleAxisd(share * pitch, Eigen::Vector3d::UnitY()) *
         Eigen::AngleAxisd(share * roll, Eigen::Vector3d::UnitX());
}

}  // namespace groundgrid::simulation
