#include "rendering/png_file.hpp"

#include <cairo.h>

#include <exception>
#include <memory>
#include <new>
#include <span>
#include <stdexcept>
#include <string>

#include "io/atomic_file.hpp"

namespace groundgrid::rendering {
namespace {

// No exception may pass through Cairo, which is C.
struct Output {
  io::AtomicFile file;
  std::exception_ptr problem{};
};

cairo_status_t write(void* closure, const unsigned char* data, unsigned int length) {
  auto& output = *static_cast<Output*>(closure);
  try {
    output.file.write(std::as_bytes(std::span(data, length)));
  } catch (...) {
    output.problem = std::current_exception();
    return CAIRO_STATUS_WRITE_ERROR;
  }
  return CAIRO_STATUS_SUCCESS;
}

}  // namespace

void write_png(const std::filesystem::path& path, Image image) {
  auto* const pixels = reinterpret_cast<unsigned char*>(image.pixels.data());
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_for_data(
          pixels, CAIRO_FORMAT_RGB24, image.size.width, image.size.height,
          image.size.width * static_cast<int>(sizeof(std::uint32_t))),
      &cairo_surface_destroy);
  Output output{.file = io::AtomicFile(path)};
  const cairo_status_t status = cairo_surface_write_to_png_stream(surface.get(), write, &output);
  if (output.problem) std::rethrow_exception(output.problem);
  if (status == CAIRO_STATUS_NO_MEMORY) throw std::bad_alloc();
  if (status != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error(std::string("no PNG: ") + cairo_status_to_string(status));
  output.file.commit();
}

}  // namespace groundgrid::rendering
