#pragma once

#include <memory>

namespace groundgrid::rendering {

/// An OpenGL context without a window, display or GPU of its own, current on the thread that made
/// it for as long as it lives. One at a time and thread.
class OffscreenContext {
 public:
  /// Throws std::runtime_error, saying what to install, where there is no OpenGL 3.3.
  OffscreenContext();
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;
  OffscreenContext(OffscreenContext&&) = delete;
  OffscreenContext& operator=(OffscreenContext&&) = delete;

 private:
  class Egl;
  std::unique_ptr<Egl> egl_;
};

}  // namespace groundgrid::rendering
