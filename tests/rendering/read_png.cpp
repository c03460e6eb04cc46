#include "read_png.hpp"

#include <cairo.h>

#include <cstring>
#include <memory>
#include <stdexcept>

namespace groundgrid::test {

rendering::Image read_png(const std::filesystem::path& path) {
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_image_surface_create_from_png(path.c_str()), &cairo_surface_destroy);
  if (cairo_surface_status(surface.get()) != CAIRO_STATUS_SUCCESS)
    throw std::runtime_error("no PNG: " + path.string());
  rendering::Image image{.size = {cairo_image_surface_get_width(surface.get()),
                                  cairo_image_surface_get_height(surface.get())}};
  image.pixels.resize(image.size.pixels());
  const auto width = static_cast<std::size_t>(image.size.width);
  const auto stride = static_cast<std::size_t>(cairo_image_surface_get_stride(surface.get()));
  const unsigned char* const data = cairo_image_surface_get_data(surface.get());
  for (std::size_t y = 0; y < static_cast<std::size_t>(image.size.height); ++y)
    std::memcpy(&image.pixels[y * width], data + y * stride, width * sizeof(std::uint32_t));
  return image;
}

}  // namespace groundgrid::test
