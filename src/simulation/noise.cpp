#include "simulation/noise.hpp"

#include <cmath>

namespace groundgrid::simulation {
namespace {

// Edges nearer to each other than the first look like one surface; echoes of edges farther apart
// than the second are told apart by the sensor.
constexpr double kLeastStep_m = 0.25;
constexpr double kMostStep_m = 2.0;
constexpr double kChance = 0.12;

}  // namespace

double beam_bias(const Sensor& sensor, std::size_t beam, std::uint64_t seed) {
  return sensor.bias_m * Random(hash({seed, 3, beam})).normal();
}

double measured_range(const Sensor& sensor, double distance_m, double bias_m, Random& random) {
  const double noisy = distance_m + bias_m + sensor.noise_m * random.normal();
  const double range = std::round(noisy / sensor.range_step_m) * sensor.range_step_m;
  return range < sensor.least_range_m || range > sensor.most_range_m ? 0.0 : range;
}

Echo mixed_at_edge(const Echo& echo, const Echo& neighbour, Random& random) {
  if (!(neighbour.distance_m > 0.0)) return echo;
  const double step = neighbour.distance_m - echo.distance_m;
  if (std::abs(step) < kLeastStep_m || std::abs(step) > kMostStep_m) return echo;
  if (!random.chance(kChance)) return echo;
  Echo mixed = echo.soil ? neighbour : echo;
  mixed.distance_m = echo.distance_m + random.uniform() * step;
  return mixed;
}

}  // namespace groundgrid::simulation
