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

struct FreeColorMap {
  void operator()(ColorMapObject* map) const { GifFreeMapObject(map); }
};
using ColorMapPtr = std::unique_ptr<ColorMapObject, FreeColorMap>;

// Tables of GIF have a power of two of colours.
ColorMapPtr table_of(const Palette& palette) {
  std::array<GifColorType, 256> colors{};
  std::transform(palette.colors().begin(), palette.colors().end(), colors.begin(), [](Color color) {
    return GifColorType{color.red, color.green, color.blue};
  });
  ColorMapPtr table(GifMakeMapObject(static_cast<int>(colors.size()), colors.data()));
  if (table == nullptr) throw std::bad_alloc();
  return table;
}

struct CloseGif {
  void operator()(GifFileType* gif) const { EGifCloseFile(gif, nullptr); }
};
using GifPtr = std::unique_ptr<GifFileType, CloseGif>;

}  // namespace

class GifFile::Writer {
 public:
  Writer(const std::filesystem::path& path, ImageSize size, double frames_per_second,
         Palette palette)
      : file_(path),
        size_(size),
        palette_(std::move(palette)),
        delay_(std::max(2, static_cast<int>(std::lround(100.0 / frames_per_second)))) {
    int error = 0;
    gif_.reset(EGifOpen(this, &write, &error));
    if (gif_ == nullptr) throw std::bad_alloc();
    EGifSetGifVersion(gif_.get(), true);
    check(EGifPutScreenDesc(gif_.get(), size.width, size.height, 8, 0, table_of(palette_).get()));
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
    std::vector<GifByteType> pixels = palette_.indices(image);
    put_delay();
    check(EGifPutImageDesc(gif_.get(), 0, 0, size_.width, size_.height, false, nullptr));
    const auto width = static_cast<std::size_t>(size_.width);
    for (std::size_t first = 0; first < pixels.size(); first += width)
      check(EGifPutLine(gif_.get(), &pixels[first], size_.width));
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
  Palette palette_;
  int delay_;  ///< Of each frame, hundredths of a second.
  std::exception_ptr problem_{};
  GifPtr gif_{};  ///< Last, since closing it still writes.
};

GifFile::GifFile(const std::filesystem::path& path, ImageSize size, double frames_per_second,
                 Palette palette)
    : writer_(std::make_unique<Writer>(path, size, frames_per_second, std::move(palette))) {}
GifFile::~GifFile() = default;

void GifFile::add(const Image& image) { writer_->add(image); }
void GifFile::commit() { writer_->commit(); }

}  // namespace groundgrid::rendering
