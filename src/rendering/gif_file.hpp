#pragma once

#include <filesystem>
#include <memory>

#include "rendering/image.hpp"
#include "rendering/palette.hpp"

namespace groundgrid::rendering {

/// A GIF that plays again and again, written frame by frame, complete or not at all: without
/// commit() nothing is left. All frames have the same palette.
class GifFile {
 public:
  /// Throws io::Error where the file cannot be written.
  GifFile(const std::filesystem::path& path, ImageSize size, double frames_per_second,
          Palette palette);
  ~GifFile();
  GifFile(const GifFile&) = delete;
  GifFile& operator=(const GifFile&) = delete;
  GifFile(GifFile&&) = delete;
  GifFile& operator=(GifFile&&) = delete;

  /// Throws std::invalid_argument where the image is of another size, io::Error.
  void add(const Image& image);

  /// Throws io::Error.
  void commit();

 private:
  class Writer;
  std::unique_ptr<Writer> writer_;
};

}  // namespace groundgrid::rendering
