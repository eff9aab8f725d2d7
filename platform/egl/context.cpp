#include "platform/egl/context.h"

#include <EGL/eglext.h>
#include <fmt/format.h>

#include <string_view>
#include <vector>

namespace docent::egl {
namespace {

std::string_view name_of_error(EGLint error) {
  switch (error) {
    case EGL_NOT_INITIALIZED:
      return "not initialised";
    case EGL_BAD_ACCESS:
      return "access denied";
    case EGL_BAD_ALLOC:
      return "out of memory";
    case EGL_BAD_CONFIG:
      return "bad configuration";
    case EGL_BAD_MATCH:
      return "the configuration does not match";
    case EGL_BAD_NATIVE_WINDOW:
      return "bad native window";
    case EGL_BAD_PARAMETER:
      return "the platform is not supported";
    default:
      return "no reason given";
  }
}

std::unexpected<Error> egl_failed(std::string_view what) {
  const EGLint error = eglGetError();
  return std::unexpected(Error{
      Errc::Environment,
      fmt::format("{}: {} (EGL 0x{:04x}); is a Mesa or vendor driver with OpenGL ES 3 installed "
                  "(libegl-mesa0, libgl1-mesa-dri)?",
                  what, name_of_error(error), error)});
}

}  // namespace

void DestroyContext::operator()(EGLContext context) const noexcept {
  if (eglGetCurrentContext() == context)
    eglMakeCurrent(display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
  eglDestroyContext(display, context);
}

Result<EglDisplay> open_egl(EGLenum platform, void* native) {
  const EGLDisplay raw = eglGetPlatformDisplay(platform, native, nullptr);
  if (raw == EGL_NO_DISPLAY) return egl_failed("the display cannot be opened");
  EglDisplay display(raw);
  if (!eglInitialize(display.get(), nullptr, nullptr))
    return egl_failed("the display cannot be initialised");
  if (!eglBindAPI(EGL_OPENGL_ES_API)) return egl_failed("the driver has no OpenGL ES");
  return display;
}

Result<EGLConfig> choose_config(EGLDisplay display, const ConfigNeeds& needs) {
  const EGLint wanted[] = {EGL_SURFACE_TYPE,
                           needs.surface_type,
                           EGL_RENDERABLE_TYPE,
                           EGL_OPENGL_ES3_BIT,
                           EGL_RED_SIZE,
                           8,
                           EGL_GREEN_SIZE,
                           8,
                           EGL_BLUE_SIZE,
                           8,
                           EGL_NONE};
  EGLint count = 0;
  if (!eglChooseConfig(display, wanted, nullptr, 0, &count) || count == 0)
    return egl_failed("the display has no 8-bit colour for OpenGL ES 3");
  std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
  eglChooseConfig(display, wanted, configs.data(), count, &count);
  for (EGLConfig config : configs)
    if (!needs.native_visual || native_visual_of(display, config) == *needs.native_visual)
      return config;
  return egl_failed("the display has no colour format that the window can take");
}

EGLint native_visual_of(EGLDisplay display, EGLConfig config) noexcept {
  EGLint visual = 0;
  eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
  return visual;
}

Result<EglContext> make_context(EGLDisplay display, EGLConfig config) {
  const EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_CONTEXT_MINOR_VERSION, 0, EGL_NONE};
  const EGLContext raw = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  if (raw == EGL_NO_CONTEXT) return egl_failed("an OpenGL ES 3 context cannot be made");
  return EglContext(raw, DestroyContext{display});
}

Result<EglSurface> make_window_surface(EGLDisplay display, EGLConfig config, void* native_window) {
  const EGLSurface raw = eglCreatePlatformWindowSurface(display, config, native_window, nullptr);
  if (raw == EGL_NO_SURFACE) return egl_failed("the window cannot be drawn to");
  return EglSurface(raw, DestroySurface{display});
}

Result<void> make_current(EGLDisplay display, EGLSurface surface, EGLContext context) {
  if (!eglMakeCurrent(display, surface, surface, context))
    return egl_failed("the OpenGL context cannot be used");
  return {};
}

std::uint32_t age_of(EGLDisplay display, EGLSurface surface) noexcept {
  EGLint age = 0;
  const bool is_told = eglQuerySurface(display, surface, EGL_BUFFER_AGE_EXT, &age) == EGL_TRUE;
  return is_told && age > 0 ? static_cast<std::uint32_t>(age) : 0;
}

}  // namespace docent::egl
