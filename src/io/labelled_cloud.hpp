#pragma once

#include <cstdint>
#include <filesystem>
#include <span>

#include "io/atomic_file.hpp"
#include "io/point_cloud.hpp"
#include "io/scan_format.hpp"

namespace groundgrid::io {

/// Writes a cloud with all its fields, in their order and types, and after them `label` (uint32,
/// SemanticKITTI numbers) and `height_above_ground` (float32, metres), complete or not at all.
/// Fields of these two names that the cloud has already are replaced. `format` is pcd or ply; the
/// encoding, the byte order, an organised shape and the viewpoint stay as they were read, as far as
/// the format has them (PLY knows neither binary_compressed nor rows: binary little-endian). With a
/// batch the file has its name once that is committed. Throws std::invalid_argument where the
/// lengths differ from the cloud's, Error where the file cannot be written.
void write_labelled_cloud(const std::filesystem::path& path, ScanFormat format,
                          const PointCloud& cloud, std::span<const std::uint32_t> labels,
                          std::span<const float> height_above_ground, FileBatch* batch = nullptr);

}  // namespace groundgrid::io
