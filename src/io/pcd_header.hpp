#pragma once

#include "io/input_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads the header of a PCD file (versions 0.5 to 0.7) into a cleared cloud: its fields as they
/// lie in the file, padding among them, its shape, viewpoint and encoding. The file's position is
/// then that of the points. WIDTH, HEIGHT, POINTS and COUNT may be missing where the others say
/// what they are. Throws Error, with the line, where the header is none or contradicts itself.
void read_pcd_header(InputFile& file, PointCloud& cloud);

}  // namespace groundgrid::io
