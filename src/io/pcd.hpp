#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads a file of the Point Cloud Library into a cleared cloud: ascii, binary and
/// binary_compressed, with fields of any type, without the padding among them. Bytes after the
/// last point of a binary file are only counted (surplus_bytes), further lines of an ascii one are
/// an error. Throws Error as read_scan says.
void read_pcd(const std::filesystem::path& path, PointCloud& cloud);

}  // namespace groundgrid::io
