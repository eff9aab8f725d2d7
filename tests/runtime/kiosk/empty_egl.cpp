// The yardstick of what docent keeps for itself: a program that has a picture of 1920 x 1080 by
// OpenGL ES in memory, and nothing else. It says how many megabytes it has that are of no file.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

namespace {

constexpr int width = 1920, height = 1080;

bool make_context(EGLDisplay display) {
  constexpr std::array<EGLint, 7> wanted{EGL_SURFACE_TYPE,
                                         EGL_PBUFFER_BIT,
                                         EGL_RENDERABLE_TYPE,
                                         EGL_OPENGL_ES3_BIT,
                                         EGL_DEPTH_SIZE,
                                         24,
                                         EGL_NONE};
  constexpr std::array<EGLint, 5> size{EGL_WIDTH, width, EGL_HEIGHT, height, EGL_NONE};
  constexpr std::array<EGLint, 3> version{EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint count = 0;
  if (eglInitialize(display, nullptr, nullptr) == EGL_FALSE ||
      eglBindAPI(EGL_OPENGL_ES_API) == EGL_FALSE ||
      eglChooseConfig(display, wanted.data(), &config, 1, &count) == EGL_FALSE || count == 0)
    return false;
  const EGLSurface surface = eglCreatePbufferSurface(display, config, size.data());
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version.data());
  return eglMakeCurrent(display, surface, surface, context) == EGL_TRUE;
}

double anonymous_megabytes() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("RssAnon:")) return std::strtod(line.c_str() + 8, nullptr) * 1024 / 1e6;
  return 0;
}

}  // namespace

int main() {
  if (!make_context(
          eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr))) {
    std::fprintf(stderr, "empty_egl: no context\n");
    return 1;
  }
  std::array<unsigned char, 4> pixel{};  // asked for, so that all is drawn
  glClearColor(0.5F, 0.5F, 0.5F, 1);
  glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
  glReadPixels(0, 0, 1, 1, GL_RGBA, GL_UNSIGNED_BYTE, pixel.data());
  std::printf("%.1f\n", anonymous_megabytes());
  return 0;
}
