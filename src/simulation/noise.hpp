#pragma once

#include "simulation/echo.hpp"
#include "simulation/random.hpp"
#include "simulation/sensors.hpp"

namespace groundgrid::simulation {

/// What a laser always adds to its ranges.
double beam_bias(const Sensor& sensor, std::size_t beam, std::uint64_t seed);

/// A range as the sensor gives it: with noise, bias and in its steps. 0 where it is too short.
double measured_range(const Sensor& sensor, double distance_m, double bias_m, Random& random);

/// A beam that meets an edge may give a range between the two surfaces, if they are too close to
/// each other to be told apart. Returns the echo, or what becomes of it beside `neighbour`.
Echo mixed_at_edge(const Echo& echo, const Echo& neighbour, Random& random);

}  // namespace groundgrid::simulation
