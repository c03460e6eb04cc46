#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <vector>

#include "groundgrid/label.hpp"
#include "io/atomic_file.hpp"

namespace groundgrid::io {

/// The class of a SemanticKITTI label; the upper 16 bits number the instance.
constexpr std::uint16_t semantic_kitti_class(std::uint32_t label) {
  return static_cast<std::uint16_t>(label & 0xFFFFU);
}

/// What we write for an answer: 40 ground, 99 obstacle, 1 outlier, 0 unknown.
constexpr std::uint32_t semantic_kitti_label(Label label) {
  // Choices that compilers make for many labels at once, as they do not for a switch.
  const std::uint32_t if_no_ground = label == Label::obstacle ? 99 : 0;
  const std::uint32_t if_no_outlier = label == Label::ground ? 40 : if_no_ground;
  return label == Label::outlier ? 1 : if_no_outlier;
}

/// Reads a .label file (one little-endian 32-bit number per point) into `labels`, whose memory is
/// reused. Throws Error where the file cannot be read or does not hold exactly `points` labels,
/// which is the number of points in `scan`.
void read_labels(const std::filesystem::path& path, const std::filesystem::path& scan,
                 std::size_t points, std::vector<std::uint32_t>& labels);

/// Writes a .label file in the same form, complete or not at all; with a batch it has its
/// name once that is committed. Throws Error.
void write_labels(const std::filesystem::path& path, std::span<const std::uint32_t> labels,
                  FileBatch* batch = nullptr);

}  // namespace groundgrid::io
