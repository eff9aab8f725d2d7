#include "platform/headless/headless_display.h"

#include <EGL/egl.h>
// after egl.h, which it needs
#include <EGL/eglext.h>
#include <GLES3/gl3.h>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "platform/egl/context.h"

namespace docent::headless {
namespace {

/// A framebuffer that encodes sRGB itself, so blending is in linear light.
struct Framebuffer {
  GLuint name = 0, colour = 0;
  Framebuffer() = default;
  Framebuffer(const Framebuffer&) = delete;
  Framebuffer& operator=(const Framebuffer&) = delete;
  ~Framebuffer() {
    if (name == 0) return;
    glDeleteFramebuffers(1, &name);
    glDeleteRenderbuffers(1, &colour);
  }
};

class Headless final : public HeadlessDisplay {
 public:
  Headless(egl::EglDisplay display, egl::EglContext context, PixelSize size)
      : display_(std::move(display)), context_(std::move(context)), size_(size) {}

  bool make_framebuffer() noexcept {
    glGenRenderbuffers(1, &framebuffer_.colour);
    glBindRenderbuffer(GL_RENDERBUFFER, framebuffer_.colour);
    glRenderbufferStorage(GL_RENDERBUFFER, GL_SRGB8_ALPHA8, static_cast<GLsizei>(size_.width),
                          static_cast<GLsizei>(size_.height));
    glGenFramebuffers(1, &framebuffer_.name);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER,
                              framebuffer_.colour);
    return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
  }

  DisplayState wait_for_page_flip() noexcept override { return DisplayState::Open; }
  std::string description() const override {
    return fmt::format("memory, {} x {} pixels", size_.width, size_.height);
  }
  RenderTarget target() const noexcept override {
    return {framebuffer_.name, size_, Encoding::Srgb, Rotation::None};
  }
  void present() noexcept override { glFlush(); }

  void read_back(Pixels& picture) const override {
    picture.width = size_.width;
    picture.height = size_.height;
    picture.rgba.resize(std::size_t{4} * size_.width * size_.height);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer_.name);
    glPixelStorei(GL_PACK_ALIGNMENT, 4);
    glReadPixels(0, 0, static_cast<GLsizei>(size_.width), static_cast<GLsizei>(size_.height),
                 GL_RGBA, GL_UNSIGNED_BYTE, picture.rgba.data());
    turn_upside_down(picture);
  }

 private:
  /// OpenGL's rows begin at the bottom, a picture's at the top.
  static void turn_upside_down(Pixels& picture) noexcept {
    const auto stride = static_cast<std::ptrdiff_t>(4) * picture.width;
    auto top = picture.rgba.begin();
    auto bottom = picture.rgba.end() - stride;
    for (; top < bottom; top += stride, bottom -= stride)
      std::swap_ranges(top, top + stride, bottom);
  }

  egl::EglDisplay display_;
  egl::EglContext context_;
  PixelSize size_;
  Framebuffer framebuffer_;  // last: it goes while the context is still there
};

}  // namespace

Result<std::unique_ptr<HeadlessDisplay>> open_headless(PixelSize size) {
  auto display = egl::open_egl(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY);
  if (!display) return std::unexpected(display.error());
  const auto config = egl::choose_config(display->get(), {});
  if (!config) return std::unexpected(config.error());
  auto context = egl::make_context(display->get(), *config);
  if (!context) return std::unexpected(context.error());
  if (const auto current = egl::make_current(display->get(), EGL_NO_SURFACE, context->get());
      !current)
    return std::unexpected(current.error());

  GLint longest = 0;
  glGetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &longest);
  const auto fits = [&](std::uint32_t side) {
    return side > 0 && side <= static_cast<std::uint32_t>(longest);
  };
  auto headless = std::make_unique<Headless>(std::move(*display), std::move(*context), size);
  if (!fits(size.width) || !fits(size.height) || !headless->make_framebuffer())
    return std::unexpected(Error{
        Errc::Environment,
        fmt::format("a headless display of {} x {} pixels cannot be made; each side may be 1 to {}",
                    size.width, size.height, longest)});
  return headless;
}

}  // namespace docent::headless
