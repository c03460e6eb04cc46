#include "rendering/render_target.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <stdexcept>

#include "rendering/gl.hpp"

namespace groundgrid::rendering {
namespace {

GLuint make_texture(ImageSize size, GLint stored, GLenum channels, GLenum type) {
  GLuint texture = 0;
  glGenTextures(1, &texture);
  glBindTexture(GL_TEXTURE_2D, texture);
  glTexImage2D(GL_TEXTURE_2D, 0, stored, size.width, size.height, 0, channels, type, nullptr);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  return texture;
}

}  // namespace

RenderTarget::RenderTarget(ImageSize size)
    : size_(size),
      color_(make_texture(size, GL_RGBA8, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV)),
      depth_(make_texture(size, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT)) {
  glGenFramebuffers(1, &framebuffer_);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color_, 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_, 0);
  if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
    throw std::runtime_error("OpenGL has no room for a picture of this size; choose a smaller one");
}

RenderTarget::~RenderTarget() {
  glDeleteFramebuffers(1, &framebuffer_);
  glDeleteTextures(1, &color_);
  glDeleteTextures(1, &depth_);
}

void RenderTarget::begin() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glViewport(0, 0, size_.width, size_.height);
  glClearColor(1.0F, 1.0F, 1.0F, 1.0F);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void RenderTarget::bind_textures() const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, color_);
  glActiveTexture(GL_TEXTURE1);
  glBindTexture(GL_TEXTURE_2D, depth_);
  glActiveTexture(GL_TEXTURE0);
}

Image RenderTarget::read() const {
  Image image{.size = size_, .pixels = std::vector<std::uint32_t>(size_.pixels())};
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_);
  glReadPixels(0, 0, size_.width, size_.height, GL_BGRA, GL_UNSIGNED_INT_8_8_8_8_REV,
               image.pixels.data());
  // OpenGL counts rows from below.
  const std::ptrdiff_t width = size_.width;
  const auto row = [&image, width](int y) { return image.pixels.begin() + y * width; };
  for (int y = 0; y < size_.height / 2; ++y)
    std::swap_ranges(row(y), row(y + 1), row(size_.height - 1 - y));
  for (std::uint32_t& pixel : image.pixels) pixel |= 0xFF000000U;
  return image;
}

}  // namespace groundgrid::rendering
