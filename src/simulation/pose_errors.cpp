#include "simulation/pose_errors.hpp"

#include "simulation/random.hpp"

namespace groundgrid::simulation {
namespace {

Eigen::Vector3d normal_vector(Random& random) {
  const double x = random.normal();
  const double y = random.normal();
  return {x, y, random.normal()};
}

}  // namespace

Eigen::Isometry3d PoseErrors::estimate(const Eigen::Isometry3d& truth) {
  const std::size_t scan = scan_++;
  if (scan == 0) return truth;
  Random random(hash({seed_, 4, scan}));
  drift_ += options_.drift_m_per_scan * normal_vector(random);
  return Eigen::Translation3d(drift_ + options_.noise_m * normal_vector(random)) * truth;
}

}  // namespace groundgrid::simulation
