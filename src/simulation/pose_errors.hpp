#pragma once

#include <Eigen/Geometry>
#include <cstddef>
#include <cstdint>

namespace groundgrid::simulation {

/// How far a localisation is off. Standard deviations, in each direction.
struct PoseErrorOptions {
  double noise_m = 0.0;           ///< Of each pose but the first.
  double drift_m_per_scan = 0.0;  ///< Of what adds up from scan to scan.
};

/// What a localisation makes of the true poses of a drive, from the first scan on.
class PoseErrors {
 public:
  PoseErrors(const PoseErrorOptions& options, std::uint64_t seed)
      : options_(options), seed_(seed) {}

  /// The pose as it is taken to be at the next scan. That of the first scan is right.
  Eigen::Isometry3d estimate(const Eigen::Isometry3d& truth);

 private:
  PoseErrorOptions options_;
  std::uint64_t seed_;
  std::size_t scan_ = 0;
  Eigen::Vector3d drift_ = Eigen::Vector3d::Zero();
};

}  // namespace groundgrid::simulation
