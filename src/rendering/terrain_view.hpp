#pragma once

#include "rendering/map_picture.hpp"
#include "rendering/perspective.hpp"
#include "rendering/view_point.hpp"

namespace groundgrid::rendering {

/// A shaded terrain as seen from a place around it, its heights `exaggeration` times as great.
/// Looking along azimuth 0 is looking north. Throws std::runtime_error where OpenGL fails.
Image draw_terrain_in_perspective(const PerspectiveRenderer& renderer,
                                  const TerrainPicture& picture, const ViewPoint& view,
                                  double exaggeration, ImageSize size);

/// How much heights are to be exaggerated so that a terrain does not look flat: a round number.
double fitting_exaggeration(const TerrainPicture& picture);

}  // namespace groundgrid::rendering
