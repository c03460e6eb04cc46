#pragma once

#include <cstddef>
#include <filesystem>
#include <vector>

namespace groundgrid::io {

/// Reads what a simulated drive says of a scan's points: how high each lies above the soil, metres,
/// float32, little-endian, one a point. Throws Error where the file cannot be read or does not hold
/// `points` heights; `scan` is named in that case.
void read_true_heights(const std::filesystem::path& path, const std::filesystem::path& scan,
                       std::size_t points, std::vector<float>& heights);

}  // namespace groundgrid::io
