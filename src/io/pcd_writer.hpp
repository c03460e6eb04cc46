#pragma once

#include <filesystem>

#include "io/atomic_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Writes a cloud as a PCD file, complete or not at all: ascii, binary_compressed or, for every
/// other encoding, binary. A cloud that does not become smaller by compression, or is larger than
/// the 4 GB which the format can compress, is written binary too. With a batch the file has
/// its name once that is committed. Throws Error.
void write_pcd(const std::filesystem::path& path, const PointCloud& cloud,
               FileBatch* batch = nullptr);

}  // namespace groundgrid::io
