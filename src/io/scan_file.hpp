#pragma once

#include <filesystem>

#include "io/point_cloud.hpp"
#include "io/scan_format.hpp"
#include "io/scan_sequence.hpp"

namespace groundgrid::io {

/// Reads a scan in any of the formats into `cloud`, whose memory is reused. Every cloud has the
/// fields x, y and z. Coordinates are metres in the LiDAR's frame, NaN and infinite ones are kept
/// as they are. A file of no points gives an empty cloud. Throws Error that names the file, the
/// place and the remedy where the file cannot be read, is cut short, promises more points than it
/// holds or has no x, y, z; the cloud is then empty.
void read_scan(const std::filesystem::path& path, const ScanFormat& format, PointCloud& cloud);

/// Reads a scan of a sequence. Throws Error also if nobody said its layout and its numbers are
/// those of another one.
void read_scan(const ScanFile& scan, PointCloud& cloud);

}  // namespace groundgrid::io
