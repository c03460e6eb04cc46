#pragma once

namespace groundgrid::simulation {

/// The version of scenes, sensors and the meaning of seeds. Drives of the same version, scene,
/// sensor, seed and options are the same; whatever changes a point raises the number.
inline constexpr int kSimulationVersion = 1;

}  // namespace groundgrid::simulation
