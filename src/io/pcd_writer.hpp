#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Writes a cloud as a PCD file, complete or not at all: ascii, binary_compressed or, for every
/// other encoding, binary. A cloud that does not become smaller by compression, or is larger than
/// the 4 GB which the format can compress, is written binary too. Throws Error.
void write_pcd(const std::filesystem::path& path, const PointCloud& cloud);

}  // namespace groundgrid::io
