#include "rendering/gif_file.hpp"

#include <gif_lib.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "io/atomic_file.hpp"

namespace groundgrid::rendering {
namespace {

constexpr int kColors = 256;

// giflib counts colours in 32 steps, the last of which it makes 248: white would be grey.
GifByteType full_range(GifByteType value) {
  return static_cast<GifByteType>(std::min(255, (value * 255 + 124) / 248));
}

/// An image in the colours of its own table.
struct IndexedImage {
  std::array<GifColorType, kColors> colors{};
  std::vector<GifByteType> pixels{};
};

IndexedImage indexed(const Image& image) {
  const std::size_t count = image.size.pixels();
  std::vector<GifByteType> red(count);
  std::vector<GifByteType> green(count);
  std::vector<GifByteType> blue(count);
  for (std::size_t i = 0; i < count; ++i) {
    red[i] = static_cast<GifByteType>(image.pixels[i] >> 16U);
    green[i] = static_cast<GifByteType>(image.pixels[i] >> 8U);
    blue[i] = static_cast<GifByteType>(image.pixels[i]);
  }
  IndexedImage result{.pixels = std::vector<GifByteType>(count)};
  int colors = kColors;
  if (GifQuantizeBuffer(static_cast<unsigned>(image.size.width),
                        static_cast<unsigned>(image.size.height), &colors, red.data(), green.data(),
                        blue.data(), result.pixels.data(), result.colors.data()) == GIF_ERROR)
    throw std::bad_alloc();
  for (GifColorType& color : result.colors)
    color = {full_range(color.Red), full_range(color.Green), full_range(color.Blue)};
  return result;
}

struct FreeColorMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMapPtr = std::unique_ptr<ColorMapObject, FreeColorMap>;

struct CloseGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
using GifPtr = std::unique_ptr<GifFileType, CloseGif>;

}  // namespace

class GifFile::Writer {
 public:
  Writer(const std::filesystem::path& path, ImageSize size, double frames_per_second)
      : file_(path),
        size_(size),
        delay_(std::max(2, static_cast<int>(std::lround(100.0 / frames_per_second)))) {
    int error = 0;
    gif_.reset(EGifOpen(this, &write, &error));
    if (gif_ == nullptr) throw std::bad_alloc();
    EGifSetGifVersion(gif_.get(), true);
    check(EGifPutScreenDesc(gif_.get(), size.width, size.height, 8, 0, nullptr));
    put_loop();
  }
  ~Writer() = default;
  Writer(const Writer&) = delete;
  Writer& operator=(const Writer&) = delete;
  Writer(Writer&&) = delete;
  Writer& operator=(Writer&&) = delete;

  void add(const Image& image) {
    if (!(image.size == size_))
      throw std::invalid_argument("all frames of a GIF must be of the same size");
    IndexedImage frame = indexed(image);
    put_delay();
    const ColorMapPtr colors(GifMakeMapObject(kColors, frame.colors.data()));
    if (colors == nullptr) throw std::bad_alloc();
    check(EGifPutImageDesc(gif_.get(), 0, 0, size_.width, size_.height, false, colors.get()));
    for (int y = 0; y < size_.height; ++y)
      check(EGifPutLine(
          gif_.get(),
          &frame.pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(size_.width)],
          size_.width));
  }

  void commit() {
    check(EGifCloseFile(gif_.release(), nullptr));
    file_.commit();
  }

 private:
  // No exception may pass through giflib, which is C.
  static int write(GifFileType* gif, const GifByteType* data, int length) {
    auto& writer = *static_cast<Writer*>(gif->UserData);
    try {
      writer.file_.write(std::as_bytes(std::span(data, static_cast<std::size_t>(length))));
    } catch (...) {
      writer.problem_ = std::current_exception();
      return 0;
    }
    return length;
  }

  void check(int result) {
    if (problem_) std::rethrow_exception(std::exchange(problem_, nullptr));
    if (result == GIF_ERROR) throw std::runtime_error("no GIF can be made of these pictures");
  }

  // The extension by which browsers know that it goes on from the beginning.
  void put_loop() {
    constexpr std::array<GifByteType, 3> kForEver{1, 0, 0};
    const std::string name = "NETSCAPE2.0";
    check(EGifPutExtensionLeader(gif_.get(), APPLICATION_EXT_FUNC_CODE));
    check(EGifPutExtensionBlock(gif_.get(), static_cast<int>(name.size()), name.data()));
    check(EGifPutExtensionBlock(gif_.get(), static_cast<int>(kForEver.size()), kForEver.data()));
    check(EGifPutExtensionTrailer(gif_.get()));
  }

  void put_delay() {
    const GraphicsControlBlock control{.DisposalMode = DISPOSE_DO_NOT,
                                       .UserInputFlag = false,
                                       .DelayTime = delay_,
                                       .TransparentColor = NO_TRANSPARENT_COLOR};
    std::array<GifByteType, 4> bytes{};
    EGifGCBToExtension(&control, bytes.data());
    check(EGifPutExtension(gif_.get(), GRAPHICS_EXT_FUNC_CODE, static_cast<int>(bytes.size()),
                           bytes.data()));
  }

  io::AtomicFile file_;
  ImageSize size_;
  int delay_;  ///< Of each frame, hundredths of a second.
  std::exception_ptr problem_{};
  GifPtr gif_{};  ///< Last, since closing it still writes.
};

GifFile::GifFile(const std::filesystem::path& path, ImageSize size, double frames_per_second)
    : writer_(std::make_unique<Writer>(path, size, frames_per_second)) {}
GifFile::~GifFile() = default;

void GifFile::add(const Image& image) { writer_->add(image); }
void GifFile::commit() { writer_->commit(); }

}  // namespace groundgrid::rendering
