#pragma once

#include <filesystem>
#include <vector>

#include "rendering/image.hpp"

namespace groundgrid::test {

struct GifContent {
  std::vector<rendering::Image> frames{};
  int delay = 0;       ///< Of the last frame, hundredths of a second.
  bool loops = false;  ///< Says that it goes on from the beginning.
};

/// Throws std::runtime_error where it is no GIF.
GifContent read_gif(const std::filesystem::path& path);

}  // namespace groundgrid::test
