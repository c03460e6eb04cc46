#pragma once

#include <filesystem>

#include "rendering/image.hpp"

namespace groundgrid::test {

/// Throws std::runtime_error where it is no PNG.
rendering::Image read_png(const std::filesystem::path& path);

}  // namespace groundgrid::test
