#pragma once

#include "rendering/perspective.hpp"
#include "rendering/scan_picture.hpp"
#include "rendering/view_point.hpp"

namespace groundgrid::rendering {

/// The scan as seen from a place around it, with rings on the level ground below the LiDAR, each
/// with its radius. Looking along azimuth 0 is looking ahead. Throws std::invalid_argument where
/// there are not three coordinates and one group a point, std::runtime_error where OpenGL fails.
Image draw_scan_in_perspective(const PerspectiveRenderer& renderer, const ScanPicture& picture,
                               const ViewPoint& view, ImageSize size);

}  // namespace groundgrid::rendering
