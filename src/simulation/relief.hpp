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

/// How a road lies in land that is higher or lower than the road.
struct Earthwork {
  double gradient = 0.0;  ///< Of its slopes.
  double ditch_m = 0.0;   ///< The depth of its ditches.
  double bottom_m = 0.0;  ///< Their width at the bottom.
};

/// Height over the edge of the road `beyond_m` from it, where the untouched land is `land_m` over
/// that edge: a slope down to land that is lower, else a ditch and behind it a slope up to the
/// land.
double beside_road(double beyond_m, double land_m, const Earthwork& earthwork);

/// 0 up to `low`, 1 from `high` on, without a kink in between.
double smooth_step(double low, double high, double value);

}  // namespace groundgrid::simulation
