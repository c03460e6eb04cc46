#pragma once

#include <Eigen/Core>
#include <span>

#include "rendering/canvas.hpp"
#include "rendering/perspective.hpp"

namespace groundgrid::rendering {

/// From where something is looked at.
struct ViewPoint {
  double azimuth_deg = 0.0;     ///< Where the look goes, to the left of the scene's upward axis on
                                ///< a picture from above.
  double elevation_deg = 25.0;  ///< How steeply it goes down; 0: level, 90: from above.
  double distance_m = 0.0;      ///< From the eye to what is looked at; 0: as it fits.
};

/// The camera that looks so, `ahead` being the direction of azimuth 0.
Camera camera_at(const ViewPoint& view, const Eigen::Vector3d& target,
                 const Eigen::Vector3d& ahead);

/// The same, aimed and, without a distance, moved so that all the places, of which there is at
/// least one, just fill a picture of that shape.
Camera camera_around(const ViewPoint& view, std::span<const Eigen::Vector3d> places,
                     const Eigen::Vector3d& ahead, double aspect);

/// Where a plot shows a place; outside of it where that is behind the camera.
PixelPoint place_on(const Rectangle& plot, const Camera& camera, const Eigen::Vector3d& place);

}  // namespace groundgrid::rendering
