#pragma once

#include <filesystem>

#include "rendering/image.hpp"

namespace groundgrid::rendering {

/// Writes an image as a PNG, complete or not at all. Throws io::Error where the file cannot be
/// written.
void write_png(const std::filesystem::path& path, Image image);

}  // namespace groundgrid::rendering
