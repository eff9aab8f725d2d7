#include "platform/kms/swapchain.h"

#include <xf86drmMode.h>

#include <utility>

namespace docent::kms {
namespace {

/// It goes with its buffer.
struct Framebuffer {
  int fd = -1;
  std::uint32_t id = 0;
};

void forget_framebuffer(gbm_bo*, void* data) noexcept {
  const std::unique_ptr<Framebuffer> framebuffer(static_cast<Framebuffer*>(data));
  if (framebuffer && framebuffer->id != 0) drmModeRmFB(framebuffer->fd, framebuffer->id);
}

}  // namespace

Swapchain::Swapchain(Swapchain&& other) noexcept
    : size(other.size),
      gbm(std::move(other.gbm)),
      egl(std::move(other.egl)),
      shown(std::exchange(other.shown, nullptr)),
      flipping(std::exchange(other.flipping, nullptr)) {}

Swapchain& Swapchain::operator=(Swapchain&& other) noexcept {
  std::swap(size, other.size);
  std::swap(gbm, other.gbm);
  std::swap(egl, other.egl);
  std::swap(shown, other.shown);
  std::swap(flipping, other.flipping);
  return *this;
}

Swapchain::~Swapchain() {
  for (gbm_bo* buffer : {shown, flipping})
    if (buffer != nullptr) gbm_surface_release_buffer(gbm.get(), buffer);
  egl.reset();  // it draws into the other
}

void Swapchain::flipped() noexcept {
  if (flipping == nullptr) return;
  if (shown != nullptr) gbm_surface_release_buffer(gbm.get(), shown);
  shown = std::exchange(flipping, nullptr);
}

Result<Swapchain> make_swapchain(gbm_device* device, EGLDisplay display, EGLConfig config,
                                 PixelSize size) {
  Swapchain chain;
  chain.size = size;
  chain.gbm.reset(gbm_surface_create(device, size.width, size.height, scanout_format,
                                     GBM_BO_USE_SCANOUT | GBM_BO_USE_RENDERING));
  if (!chain.gbm)
    return std::unexpected(
        Error{Errc::Environment, "the graphics card has no memory for the screen's buffers"});
  auto egl = egl::make_window_surface(display, config, chain.gbm.get());
  if (!egl) return std::unexpected(egl.error());
  chain.egl = std::move(*egl);
  return chain;
}

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

}  // namespace docent::kms
