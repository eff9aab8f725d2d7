#pragma once

#include <EGL/egl.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "runtime/model/result.h"

namespace docent::egl {

struct TerminateDisplay {
  void operator()(EGLDisplay display) const noexcept { eglTerminate(display); }
};
/// An initialised EGL display. It outlives everything made from it, so declare it first.
using EglDisplay = std::unique_ptr<void, TerminateDisplay>;

struct DestroyContext {  // EGL wants the display back when a context goes
  EGLDisplay display = EGL_NO_DISPLAY;
  void operator()(EGLContext context) const noexcept;
};
using EglContext = std::unique_ptr<void, DestroyContext>;

struct DestroySurface {
  EGLDisplay display = EGL_NO_DISPLAY;
  void operator()(EGLSurface surface) const noexcept { eglDestroySurface(display, surface); }
};
using EglSurface = std::unique_ptr<void, DestroySurface>;

/// Opens EGL on a platform: EGL_PLATFORM_SURFACELESS_MESA with a null `native`,
/// EGL_PLATFORM_GBM_KHR with a gbm_device, EGL_PLATFORM_XCB_EXT with an xcb_connection_t. `native`
/// must outlive the display.
Result<EglDisplay> open_egl(EGLenum platform, void* native);

/// What a window needs of a framebuffer configuration.
struct ConfigNeeds {
  EGLint surface_type = 0;  ///< EGL_WINDOW_BIT for a window, 0 for none.
  /// EGL_NATIVE_VISUAL_ID: the GBM format or the X visual that the window is made with.
  std::optional<EGLint> native_visual;
};

/// An opaque 8-bit RGB configuration that OpenGL ES 3 can draw to.
Result<EGLConfig> choose_config(EGLDisplay display, const ConfigNeeds& needs);

/// EGL_NATIVE_VISUAL_ID of a configuration.
EGLint native_visual_of(EGLDisplay display, EGLConfig config) noexcept;

/// An OpenGL ES 3 context. It is not current yet.
Result<EglContext> make_context(EGLDisplay display, EGLConfig config);

/// A surface that shows what is drawn in a native window: a gbm_surface, or a pointer to an
/// xcb_window_t.
Result<EglSurface> make_window_surface(EGLDisplay display, EGLConfig config, void* native_window);

/// Makes the context current on this thread, drawing to `surface` (EGL_NO_SURFACE: to framebuffer
/// objects only). OpenGL calls are made on this thread alone from then on.
Result<void> make_current(EGLDisplay display, EGLSurface surface, EGLContext context);

/// What a window surface's next frame is drawn over: as Display::age() (EGL_EXT_buffer_age). The
/// surface is current.
std::uint32_t age_of(EGLDisplay display, EGLSurface surface) noexcept;

}  // namespace docent::egl
