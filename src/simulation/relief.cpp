#include "simulation/relief.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "simulation/random.hpp"

namespace groundgrid::simulation {
namespace {

constexpr double kLevelRadius_m = 25.0;

double corner(std::int64_t column, std::int64_t row, std::uint64_t seed) {
  return Random(hash({seed, static_cast<std::uint64_t>(column), static_cast<std::uint64_t>(row)}))
      .uniform(-1.0, 1.0);
}

}  // namespace

Relief::Relief(std::vector<Wave> waves) : waves_(std::move(waves)) {}

double Relief::height(const Eigen::Vector2d& place) const {
  const double level = std::exp(-place.squaredNorm() / (2.0 * kLevelRadius_m * kLevelRadius_m));
  double height = 0.0;
  for (const Wave& wave : waves_) {
    const double along = wave.number.dot(place);
    height += wave.amplitude_m * (std::cos(along + wave.phase) - std::cos(wave.phase) +
                                  level * along * std::sin(wave.phase));
  }
  return height;
}

double bumps(const Eigen::Vector2d& place, double length_m, std::uint64_t seed) {
  const Eigen::Vector2d scaled = place / length_m;
  const Eigen::Vector2d low = scaled.array().floor();
  const Eigen::Vector2d share = scaled - low;
  const auto column = static_cast<std::int64_t>(low.x());
  const auto row = static_cast<std::int64_t>(low.y());
  const double u = smooth_step(0.0, 1.0, share.x());
  const double v = smooth_step(0.0, 1.0, share.y());
  const double south = std::lerp(corner(column, row, seed), corner(column + 1, row, seed), u);
  const double north =
      std::lerp(corner(column, row + 1, seed), corner(column + 1, row + 1, seed), u);
  return std::lerp(south, north, v);
}

double beside_road(double beyond_m, double land_m, const Earthwork& earthwork) {
  const double down = earthwork.gradient * beyond_m;
  const double ditch_side = earthwork.ditch_m / earthwork.gradient;
  const double behind = std::max(0.0, beyond_m - ditch_side - earthwork.bottom_m);
  const double up = earthwork.gradient * behind - std::min(down, earthwork.ditch_m);
  return std::clamp(land_m, -down, up);
}

double smooth_step(double low, double high, double value) {
  const double share = std::clamp((value - low) / (high - low), 0.0, 1.0);
  return share * share * (3.0 - 2.0 * share);
}

}  // namespace groundgrid::simulation
