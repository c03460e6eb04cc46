#pragma once

#include "simulation/mesh.hpp"

namespace groundgrid::simulation {

/// What of the own vehicle stands in the way of a sensor at a height above the ground, in the
/// vehicle's base frame: the roof, if the sensor is above it, and ends of the roof rack beside it.
Mesh make_own_vehicle(double sensor_height_m);

}  // namespace groundgrid::simulation
