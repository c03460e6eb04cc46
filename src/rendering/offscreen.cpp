#include "rendering/offscreen.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <stdexcept>
#include <string>

namespace groundgrid::rendering {
namespace {

[[noreturn]] void fail(const std::string& step) {
  throw std::runtime_error("no OpenGL for a perspective view (" + step +
                           "): install Mesa (on Debian libegl1, libopengl0 and libgl1-mesa-dri), "
                           "or draw it from above");
}

// Mesa's platform without any surface needs neither a display nor the rights to a device.
EGLDisplay open_display() {
  const auto get_display = reinterpret_cast<PFNEGLGETPLATFORMDISPLAYEXTPROC>(
      eglGetProcAddress("eglGetPlatformDisplayEXT"));
  if (get_display == nullptr) fail("EGL knows no platforms");
  EGLDisplay display = get_display(EGL_PLATFORM_SURFACELESS_MESA, nullptr, nullptr);
  if (display == EGL_NO_DISPLAY || eglInitialize(display, nullptr, nullptr) == EGL_FALSE)
    fail("EGL finds no display without surfaces");
  return display;
}

EGLContext make_context(EGLDisplay display) {
  constexpr std::array<EGLint, 7> kAttributes{EGL_CONTEXT_MAJOR_VERSION,
                                              3,
                                              EGL_CONTEXT_MINOR_VERSION,
                                              3,
                                              EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                              EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                              EGL_NONE};
  if (eglBindAPI(EGL_OPENGL_API) == EGL_FALSE) fail("EGL has no OpenGL");
  EGLContext context =
      eglCreateContext(display, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, kAttributes.data());
  if (context == EGL_NO_CONTEXT) fail("it has no version 3.3");
  return context;
}

}  // namespace

class OffscreenContext::Egl {
 public:
  Egl() : display_(open_display()), context_(make_context(display_)) {
    if (eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE)
      fail("it cannot do without a surface");
  }
  ~Egl() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    // The display is the process's, not ours: another context may use it, and ending it would
    // unload the driver.
    eglReleaseThread();
  }
  Egl(const Egl&) = delete;
  Egl& operator=(const Egl&) = delete;
  Egl(Egl&&) = delete;
  Egl& operator=(Egl&&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_;
};

OffscreenContext::OffscreenContext() : egl_(std::make_unique<Egl>()) {}
OffscreenContext::~OffscreenContext() = default;

}  // namespace groundgrid::rendering
