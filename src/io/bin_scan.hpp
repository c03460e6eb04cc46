#pragma once

#include <filesystem>
#include <optional>

#include "io/bin_layout.hpp"
#include "io/point_cloud.hpp"

namespace groundgrid::io {

/// Reads a .bin scan (the numbers of its points and nothing else, little-endian; metres, in the
/// LiDAR's frame) into a cleared cloud, without the numbers to pass over. An empty file is a scan
/// of no points. Throws Error if the file cannot be read, is no whole number of points, does not
/// fit into memory or begins as one of another format does.
void read_bin_scan(const std::filesystem::path& path, const BinLayout& layout, PointCloud& cloud);

/// The same, throwing Error, which names the layouts that are likely, also if this is none of them.
void read_bin_scan_if_likely(const std::filesystem::path& path, const BinLayout& layout,
                             PointCloud& cloud);

/// The layout that the numbers of a .bin file tell, or the usual one if they are too few or all
/// alike; nothing if the file cannot be read, is empty or leaves a choice. See likely_layouts().
std::optional<BinLayout> guess_layout(const std::filesystem::path& path, const BinLayout& usual);

}  // namespace groundgrid::io
