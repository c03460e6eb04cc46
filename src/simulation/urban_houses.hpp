#pragma once

#include "simulation/scene_builder.hpp"
#include "simulation/urban_street.hpp"

namespace groundgrid::simulation::urban {

/// A tub of stone with flowers, along x from 0 to its length.
Plant make_planter(double length_m, double height_m);

/// The land of one house, from s on, on one side of the street: what bounds it, its garden, its
/// drive and the house with its steps.
void build_lot(SceneBuilder& town, const Street& street, double s, double side);

}  // namespace groundgrid::simulation::urban
