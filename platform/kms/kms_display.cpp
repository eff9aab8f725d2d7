#include "platform/kms/kms_display.h"

#include <EGL/egl.h>
// eglext.h needs egl.h before it
#include <EGL/eglext.h>
#include <fmt/format.h>
#include <gbm.h>
#include <poll.h>

#include <cerrno>
#include <cstring>
#include <optional>
#include <utility>

#include "platform/egl/context.h"
#include "platform/kms/console.h"
#include "platform/kms/graphics_card.h"

namespace docent::kms {
namespace {

using GbmDevice = std::unique_ptr<gbm_device, CloseWith<gbm_device_destroy>>;
using GbmSurface = std::unique_ptr<gbm_surface, CloseWith<gbm_surface_destroy>>;
using AtomicRequest = std::unique_ptr<drmModeAtomicReq, CloseWith<drmModeAtomicFree>>;

/// The kernel's name for a buffer; it goes with the buffer.
struct Framebuffer {
  int fd = -1;
  std::uint32_t id = 0;
};

void forget_framebuffer(gbm_bo*, void* data) noexcept {
  const std::unique_ptr<Framebuffer> framebuffer(static_cast<Framebuffer*>(data));
  if (framebuffer && framebuffer->id != 0) drmModeRmFB(framebuffer->fd, framebuffer->id);
}

/// Names a buffer the first time it is seen; a surface has three or four of them, so this soon
/// stops.
std::uint32_t framebuffer_of(int fd, gbm_bo* buffer) noexcept {
  if (const auto* known = static_cast<Framebuffer*>(gbm_bo_get_user_data(buffer))) return known->id;
  auto framebuffer = std::make_unique<Framebuffer>(Framebuffer{fd, 0});
  const std::uint32_t handles[4] = {gbm_bo_get_handle(buffer).u32, 0, 0, 0};
  const std::uint32_t strides[4] = {gbm_bo_get_stride(buffer), 0, 0, 0};
  const std::uint32_t offsets[4] = {0, 0, 0, 0};
  drmModeAddFB2(fd, gbm_bo_get_width(buffer), gbm_bo_get_height(buffer), gbm_bo_get_format(buffer),
                handles, strides, offsets, &framebuffer->id, 0);
  const std::uint32_t id = framebuffer->id;
  gbm_bo_set_user_data(buffer, framebuffer.release(), forget_framebuffer);
  return id;
}

class Kms final : public KmsDisplay {
 public:
  explicit Kms(GraphicsCard card) : card_(std::move(card)) {}
  Kms(const Kms&) = delete;
  Kms& operator=(const Kms&) = delete;

  ~Kms() override {
    finish_flip(1000);
    if (shown_ != nullptr) gbm_surface_release_buffer(surface_.get(), shown_);
    if (mode_blob_ != 0) drmModeDestroyPropertyBlob(card_.fd.get(), mode_blob_);
  }

  Result<void> open() {
    const int fd = card_.fd.get();
    gbm_.reset(gbm_create_device(fd));
    if (!gbm_) return failed("GBM cannot use it");
    auto display = egl::open_egl(EGL_PLATFORM_GBM_KHR, gbm_.get());
    if (!display) return std::unexpected(display.error());
    egl_ = std::move(*display);
    const auto config =
        egl::choose_config(egl_.get(), {EGL_WINDOW_BIT, static_cast<EGLint>(format)});
    if (!config) return std::unexpected(config.error());
    const PixelSize size = mode_size();
    surface_.reset(gbm_surface_create(gbm_.get(), size.width, size.height, format,
                                      GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
    if (!surface_) return failed("it has no memory for the screen's buffers");
    auto context = egl::make_context(egl_.get(), *config);
    if (!context) return std::unexpected(context.error());
    context_ = std::move(*context);
    auto egl_surface = egl::make_window_surface(egl_.get(), *config, surface_.get());
    if (!egl_surface) return std::unexpected(egl_surface.error());
    egl_surface_ = std::move(*egl_surface);
    if (drmModeCreatePropertyBlob(fd, &card_.pipe.mode, sizeof card_.pipe.mode, &mode_blob_) != 0)
      return failed("it does not take the screen's mode");
    if (auto console = QuietConsole::take()) console_.emplace(std::move(*console));
    request_.reset(drmModeAtomicAlloc());
    if (!request_) return failed("out of memory");
    return egl::make_current(egl_.get(), egl_surface_.get(), context_.get());
  }

  DisplayState wait_for_page_flip() noexcept override {
    // A screen that was unplugged never flips: a second is enough to notice, and the next present
    // sets the mode anew.
    finish_flip(1000);
    return state_;
  }

  RenderTarget target() const noexcept override {
    return {0, mode_size(), Encoding::Plain, Rotation::None};
  }

  void present() noexcept override {
    if (!eglSwapBuffers(egl_.get(), egl_surface_.get())) {
      state_ = DisplayState::Lost;
      return;
    }
    gbm_bo* next = gbm_surface_lock_front_buffer(surface_.get());
    if (next == nullptr) return;
    if (commit(framebuffer_of(card_.fd.get(), next))) {
      flipping_ = next;
      is_mode_set_ = true;
    } else {
      gbm_surface_release_buffer(surface_.get(), next);
      is_mode_set_ = false;
    }
  }

  std::string description() const override {
    const Pipe& pipe = card_.pipe;
    return fmt::format("{} of {}, {} x {} pixels at {} Hz", pipe.connector_name, card_.path,
                       pipe.mode.hdisplay, pipe.mode.vdisplay, pipe.mode.vrefresh);
  }
  std::string_view loss() const noexcept override {
    return "the graphics card takes no more frames; see what the kernel says of it (journalctl -k)";
  }
  void abandon() noexcept override {
    if (console_) console_->give_back();
  }

 private:
  static constexpr std::uint32_t format = GBM_FORMAT_XRGB8888;

  std::unexpected<Error> failed(std::string_view why) const {
    return std::unexpected(Error{Errc::Environment, fmt::format("{}: {}", card_.path, why)});
  }

  PixelSize mode_size() const noexcept {
    return {card_.pipe.mode.hdisplay, card_.pipe.mode.vdisplay};
  }

  void add(std::uint32_t object, std::uint32_t property, std::uint64_t value) noexcept {
    drmModeAtomicAddProperty(request_.get(), object, property, value);
  }

  void add_mode() noexcept {
    const Pipe& pipe = card_.pipe;
    const PipeProperties& p = pipe.properties;
    add(pipe.connector, p.connector_crtc, pipe.crtc);
    add(pipe.crtc, p.crtc_mode, mode_blob_);
    add(pipe.crtc, p.crtc_active, 1);
  }

  void add_picture(std::uint32_t framebuffer) noexcept {
    const Pipe& pipe = card_.pipe;
    const PipeProperties& p = pipe.properties;
    const PixelSize size = mode_size();
    constexpr unsigned fixed_point = 16;  // source rectangles are in 16.16
    add(pipe.plane, p.plane_fb, framebuffer);
    add(pipe.plane, p.plane_crtc, pipe.crtc);
    add(pipe.plane, p.plane_src_x, 0);
    add(pipe.plane, p.plane_src_y, 0);
    add(pipe.plane, p.plane_src_w, std::uint64_t{size.width} << fixed_point);
    add(pipe.plane, p.plane_src_h, std::uint64_t{size.height} << fixed_point);
    add(pipe.plane, p.plane_crtc_x, 0);
    add(pipe.plane, p.plane_crtc_y, 0);
    add(pipe.plane, p.plane_crtc_w, size.width);
    add(pipe.plane, p.plane_crtc_h, size.height);
  }

  bool commit(std::uint32_t framebuffer) noexcept {
    drmModeAtomicSetCursor(request_.get(), 0);
    std::uint32_t flags = DRM_MODE_PAGE_FLIP_EVENT | DRM_MODE_ATOMIC_NONBLOCK;
    if (!is_mode_set_) {
      add_mode();
      flags = DRM_MODE_PAGE_FLIP_EVENT | DRM_MODE_ATOMIC_ALLOW_MODESET;
    }
    add_picture(framebuffer);
    return drmModeAtomicCommit(card_.fd.get(), request_.get(), flags, this) == 0;
  }

  void finish_flip(int patience_ms) noexcept {
    drmEventContext events{};
    events.version = 3;
    events.page_flip_handler2 = [](int, unsigned, unsigned, unsigned, unsigned, void* data) {
      static_cast<Kms*>(data)->flipped();
    };
    while (flipping_ != nullptr) {
      pollfd card{.fd = card_.fd.get(), .events = POLLIN, .revents = 0};
      const int ready = poll(&card, 1, patience_ms);
      if (ready < 0 && errno == EINTR) continue;
      if (ready <= 0) {
        flipped();
        is_mode_set_ = false;
      } else if (drmHandleEvent(card_.fd.get(), &events) != 0) {
        state_ = DisplayState::Lost;
        return;
      }
    }
  }

  void flipped() noexcept {
    if (shown_ != nullptr) gbm_surface_release_buffer(surface_.get(), shown_);
    shown_ = std::exchange(flipping_, nullptr);
  }

  std::optional<QuietConsole> console_;
  GraphicsCard card_;
  GbmDevice gbm_;
  egl::EglDisplay egl_;
  GbmSurface surface_;
  egl::EglContext context_;
  egl::EglSurface egl_surface_;
  AtomicRequest request_;
  std::uint32_t mode_blob_ = 0;
  gbm_bo* shown_ = nullptr;     ///< On the glass.
  gbm_bo* flipping_ = nullptr;  ///< Will be on the glass at the next vertical blank.
  bool is_mode_set_ = false;
  DisplayState state_ = DisplayState::Open;
};

}  // namespace

Result<std::unique_ptr<KmsDisplay>> open_kms(PixelSize wanted) {
  auto card = open_graphics_card(wanted);
  if (!card) return std::unexpected(card.error());
  auto kms = std::make_unique<Kms>(std::move(*card));
  if (auto opened = kms->open(); !opened) return std::unexpected(opened.error());
  return kms;
}

bool is_kms_free() noexcept {
  return open_graphics_card({}).has_value();
}

}  // namespace docent::kms
