#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads the element `vertex` of a PLY file (ascii, binary of either byte order) into a cleared
/// cloud. Other elements, before or after it, and lists among its properties are skipped; bytes
/// after the last record of a binary file are counted (surplus_bytes). Throws Error as read_scan
/// says.
void read_ply(const std::filesystem::path& path, PointCloud& cloud);

}  // namespace groundgrid::io
