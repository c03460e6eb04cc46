#pragma once

#include "rendering/image.hpp"

namespace groundgrid::rendering {

/// Textures of colour and depth that OpenGL draws into. Needs a current context all its life.
class RenderTarget {
 public:
  /// Throws std::runtime_error where OpenGL has no room for it.
  explicit RenderTarget(ImageSize size);
  ~RenderTarget();
  RenderTarget(const RenderTarget&) = delete;
  RenderTarget& operator=(const RenderTarget&) = delete;
  RenderTarget(RenderTarget&&) = delete;
  RenderTarget& operator=(RenderTarget&&) = delete;

  /// What is drawn from here on goes here, on white.
  void begin() const;
  /// Makes colour and depth the textures 0 and 1.
  void bind_textures() const;
  /// What was drawn.
  [[nodiscard]] Image read() const;

 private:
  ImageSize size_;
  unsigned int color_ = 0;
  unsigned int depth_ = 0;
  unsigned int framebuffer_ = 0;
};

}  // namespace groundgrid::rendering
