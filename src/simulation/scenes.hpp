#pragma once

#include <cstdint>

#include "simulation/scene.hpp"

namespace groundgrid::simulation {

/// How far the world reaches beyond the driven stretch, and beside the path. Sensors see no
/// farther.
inline constexpr double kMargin_m = 100.0;

Scene make_urban(std::uint64_t seed, double length_m);
Scene make_hill(std::uint64_t seed, double length_m);
Scene make_motorway(std::uint64_t seed, double length_m);
Scene make_village(std::uint64_t seed, double length_m);
Scene make_offroad(std::uint64_t seed, double length_m);

}  // namespace groundgrid::simulation
