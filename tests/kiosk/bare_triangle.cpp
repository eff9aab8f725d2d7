// The yardstick of tests/kiosk/display_test.py: the least that a program can do to have a picture
// by OpenGL ES on the screen of the first graphics card. It draws one triangle and stays until it
// is killed.

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <fcntl.h>
#include <gbm.h>
#include <unistd.h>
#include <xf86drm.h>
#include <xf86drmMode.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

namespace {

constexpr const char* corners = R"(#version 300 es
void main() {
  gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 1.5 - 0.75, 0, 1);
})";
constexpr const char* colour = R"(#version 300 es
precision mediump float;
out vec4 seen;
void main() { seen = vec4(0.8, 0.3, 0.2, 1); })";

[[noreturn]] void fail(const char* what) {
  std::fprintf(stderr, "bare_triangle: %s\n", what);
  std::exit(1);
}

/// The first screen of the card, in the mode that it prefers.
struct Screen {
  drmModeConnector* connector = nullptr;
  std::uint32_t crtc = 0;
};

Screen find_screen(int card) {
  drmModeRes* resources = drmModeGetResources(card);
  for (int i = 0; resources != nullptr && i < resources->count_connectors; ++i) {
    drmModeConnector* connector = drmModeGetConnector(card, resources->connectors[i]);
    if (connector != nullptr && connector->connection == DRM_MODE_CONNECTED &&
        connector->count_modes > 0)
      return {connector, resources->crtcs[0]};
  }
  fail("no screen");
}

EGLConfig find_config(EGLDisplay display) {
  constexpr EGLint wanted[] = {EGL_SURFACE_TYPE, EGL_WINDOW_BIT, EGL_RENDERABLE_TYPE,
                               EGL_OPENGL_ES3_BIT, EGL_NONE};
  EGLint count = 0;
  eglChooseConfig(display, wanted, nullptr, 0, &count);
  std::vector<EGLConfig> configs(static_cast<std::size_t>(count));
  eglChooseConfig(display, wanted, configs.data(), count, &count);
  for (EGLConfig config : configs) {
    EGLint visual = 0;
    eglGetConfigAttrib(display, config, EGL_NATIVE_VISUAL_ID, &visual);
    if (visual == GBM_FORMAT_XRGB8888) return config;
  }
  fail("no colour format");
}

void draw_triangle() {
  const GLuint program = glCreateProgram();
  for (const auto& [kind, text] :
       {std::pair(GL_VERTEX_SHADER, corners), std::pair(GL_FRAGMENT_SHADER, colour)}) {
    const GLuint shader = glCreateShader(static_cast<GLenum>(kind));
    glShaderSource(shader, 1, &text, nullptr);
    glCompileShader(shader);
    glAttachShader(program, shader);
  }
  glLinkProgram(program);
  glUseProgram(program);
  glClearColor(1, 1, 1, 1);
  glClear(GL_COLOR_BUFFER_BIT);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace

int main() {
  const int card = open("/dev/dri/card0", O_RDWR | O_CLOEXEC);
  if (card < 0 || drmSetMaster(card) != 0) fail("the graphics card cannot be had");
  const Screen screen = find_screen(card);
  drmModeModeInfo mode = screen.connector->modes[0];
  gbm_device* device = gbm_create_device(card);
  gbm_surface* surface =
      gbm_surface_create(device, mode.hdisplay, mode.vdisplay, GBM_FORMAT_XRGB8888,
                         GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING);
  const EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_GBM_KHR, device, nullptr);
  if (!eglInitialize(display, nullptr, nullptr) || !eglBindAPI(EGL_OPENGL_ES_API)) fail("no EGL");
  const EGLConfig config = find_config(display);
  constexpr EGLint version[] = {EGL_CONTEXT_MAJOR_VERSION, 3, EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, version);
  const EGLSurface window = eglCreatePlatformWindowSurface(display, config, surface, nullptr);
  if (!eglMakeCurrent(display, window, window, context)) fail("no OpenGL ES 3");
  draw_triangle();
  if (!eglSwapBuffers(display, window)) fail("no picture");
  gbm_bo* picture = gbm_surface_lock_front_buffer(surface);
  std::uint32_t framebuffer = 0;
  const std::uint32_t handles[4] = {gbm_bo_get_handle(picture).u32},
                      strides[4] = {gbm_bo_get_stride(picture)}, offsets[4] = {};
  if (drmModeAddFB2(card, mode.hdisplay, mode.vdisplay, GBM_FORMAT_XRGB8888, handles, strides,
                    offsets, &framebuffer, 0) != 0 ||
      drmModeSetCrtc(card, screen.crtc, framebuffer, 0, 0, &screen.connector->connector_id, 1,
                     &mode) != 0)
    fail("the screen does not take the picture");
  for (;;) pause();
}
