#pragma once

#include <gbm.h>

#include <cstdint>
#include <memory>
#include <optional>

#include "platform/display.h"
#include "platform/egl/context.h"
#include "platform/handle.h"
#include "runtime/model/result.h"

namespace docent::kms {

using GbmDevice = std::unique_ptr<gbm_device, CloseWith<gbm_device_destroy>>;
using GbmSurface = std::unique_ptr<gbm_surface, CloseWith<gbm_surface_destroy>>;
using GbmBuffer = std::unique_ptr<gbm_bo, CloseWith<gbm_bo_destroy>>;

inline constexpr std::uint32_t scanout_format = GBM_FORMAT_XRGB8888;

/// The buffers of one size that frames are drawn into: each is drawn, flipping, shown, free again.
struct Swapchain {
  PixelSize size;
  GbmSurface gbm;
  egl::EglSurface egl;
  gbm_bo* shown = nullptr;     ///< On the glass.
  gbm_bo* flipping = nullptr;  ///< Will be on the glass at the next vertical blank.

  Swapchain() = default;
  Swapchain(Swapchain&& other) noexcept;
  Swapchain& operator=(Swapchain&& other) noexcept;
  ~Swapchain();

  /// What was flipping is shown now; what was shown before is free.
  void flipped() noexcept;
};

Result<Swapchain> make_swapchain(gbm_device* device, EGLDisplay display, EGLConfig config,
                                 PixelSize size);

/// The kernel's name for a buffer, 0 where it gives none. It is asked for the first time that a
/// buffer is seen, of which a swapchain has four; it goes with the buffer.
std::uint32_t framebuffer_of(int fd, gbm_bo* buffer) noexcept;

}  // namespace docent::kms
