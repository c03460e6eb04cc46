#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace groundgrid::simulation {

/// One wave of a hilly country.
struct Wave {
  double amplitude_m = 0.0;
  Eigen::Vector2d number = Eigen::Vector2d::Zero();  ///< Radians per metre, across the crests.
  double phase = 0.0;
};

/// Hills as a sum of waves, 0 and level at the origin, where drives begin.
class Relief {
 public:
  explicit Relief(std::vector<Wave> waves);

  [[nodiscard]] double height(const Eigen::Vector2d& place) const;

 private:
  std::vector<Wave> waves_;
};

/// Smooth bumps between -1 and 1, about `length_m` from one to the next.
double bumps(const Eigen::Vector2d& place, double length_m, std::uint64_t seed);

/// 0 up to `low`, 1 from `high` on, without a kink in between.
double smooth_step(double low, double high, double value);

}  // namespace groundgrid::simulation
