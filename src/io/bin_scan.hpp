#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// Floats per point in a KITTI scan: x, y, z in metres in the LiDAR's frame, and intensity.
inline constexpr std::size_t kBinFloatsPerPoint = 4;

/// Reads a KITTI scan (.bin: x y z intensity as little-endian 32-bit floats, nothing else) into
/// `points`, whose memory is reused. An empty file is a scan of no points. Throws Error where the
/// file cannot be read, is no whole number of points or does not fit into memory.
void read_bin_scan(const std::filesystem::path& path, std::vector<float>& points);

}  // namespace groundgrid::io
