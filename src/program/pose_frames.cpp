#include "program/pose_frames.hpp"

#include <spdlog/spdlog.h>

#include <cmath>
#include <optional>

#include "io/error.hpp"

namespace groundgrid::program {
namespace {

// The poses of a relative file are text with few digits.
constexpr double kNotTurned = 1e-6;
// A shorter drive tells nothing.
constexpr double kLeastDrive_m = 5.0;

std::optional<Eigen::Isometry3d> pose_at(const io::ScanPoses& poses, const io::ScanFile& scan) {
  try {
    return poses.pose(scan);
  } catch (const io::Error&) {
    return std::nullopt;
  }
}

}  // namespace

Eigen::Isometry3d T_level_poses(const io::ScanPoses& poses, const Eigen::Matrix3d& R_level_lidar) {
  Eigen::Isometry3d T_level_poses = Eigen::Isometry3d::Identity();
  if (poses.first().linear().isIdentity(kNotTurned)) T_level_poses.linear() = R_level_lidar;
  return T_level_poses;
}

void warn_of_climb(const io::ScanPoses& poses, const io::ScanSequence& sequence) {
  std::optional<Eigen::Vector3d> last;
  double ahead = 0.0;
  double climb = 0.0;
  for (const io::ScanFile& scan : sequence.scans) {
    const auto pose = pose_at(poses, scan);
    if (!pose) continue;
    const Eigen::Vector3d step = pose->translation() - last.value_or(pose->translation());
    ahead += step.head<2>().norm();
    climb += std::abs(step.z());
    last = pose->translation();
  }
  if (ahead + climb > kLeastDrive_m && climb > ahead)
    spdlog::warn(
        "the poses climb {:.1f} m and advance {:.1f} m: z must be up; if they are a camera's, give "
        "--calibration",
        climb, ahead);
}

}  // namespace groundgrid::program
