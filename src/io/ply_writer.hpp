#pragma once

#include <filesystem>

#include "io/atomic_file.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Writes a cloud as the element `vertex` of a PLY file, complete or not at all: ascii,
/// binary_big_endian or, for every other encoding, binary_little_endian. PLY has no integers of
/// 64 bits and no fields of several numbers: the former become double, which is exact up to 2⁵³,
/// the latter one property each (hist_0, hist_1, ...). With a batch the file has its name once that
/// is committed. Throws Error, also for more than 4096 properties.
void write_ply(const std::filesystem::path& path, const PointCloud& cloud,
               FileBatch* batch = nullptr);

}  // namespace groundgrid::io
