#include "read_gif.hpp"

#include <gif_lib.h>

#include <cstring>
#include <memory>
#include <span>
#include <stdexcept>

namespace groundgrid::test {
namespace {

struct CloseGif {
  void operator()(GifFileType* gif) const { DGifCloseFile(gif, nullptr); }
};

rendering::Image image_of(const SavedImage& frame, const ColorMapObject& colors) {
  rendering::Image image{.size = {frame.ImageDesc.Width, frame.ImageDesc.Height}};
  for (std::size_t i = 0; i < image.size.pixels(); ++i) {
    const GifColorType& color = colors.Colors[frame.RasterBits[i]];
    image.pixels.push_back(rendering::pixel_of({color.Red, color.Green, color.Blue}));
  }
  return image;
}

void read_extensions(const SavedImage& frame, GifContent& content) {
  if (frame.ExtensionBlockCount == 0) return;
  for (const ExtensionBlock& block :
       std::span(frame.ExtensionBlocks, static_cast<std::size_t>(frame.ExtensionBlockCount))) {
    if (block.Function == APPLICATION_EXT_FUNC_CODE && block.ByteCount == 11)
      content.loops = std::memcmp(block.Bytes, "NETSCAPE2.0", 11) == 0;
    if (block.Function != GRAPHICS_EXT_FUNC_CODE) continue;
    GraphicsControlBlock control{};
    DGifExtensionToGCB(static_cast<std::size_t>(block.ByteCount), block.Bytes, &control);
    content.delay = control.DelayTime;
  }
}

}  // namespace

GifContent read_gif(const std::filesystem::path& path) {
  const std::unique_ptr<GifFileType, CloseGif> gif(DGifOpenFileName(path.c_str(), nullptr));
  if (gif == nullptr || DGifSlurp(gif.get()) == GIF_ERROR)
    throw std::runtime_error("no GIF: " + path.string());
  GifContent content;
  for (const SavedImage& frame :
       std::span(gif->SavedImages, static_cast<std::size_t>(gif->ImageCount))) {
    content.frames.push_back(image_of(frame, *gif->SColorMap));
    read_extensions(frame, content);
  }
  return content;
}

}  // namespace groundgrid::test
