#pragma once

#include <cstdint>
#include <optional>
#include <utility>

#include "runtime/model/pixels.h"

namespace docent::kms {

/// A picture in memory that every graphics card can scan out and no graphics driver has to draw
/// ("dumb buffer", drm_dumb(7)).
class DumbBuffer {
 public:
  /// Empty where the card has none, or no memory.
  static std::optional<DumbBuffer> holding(int fd, const Pixels& picture);
  DumbBuffer(DumbBuffer&& other) noexcept
      : fd_(other.fd_),
        handle_(std::exchange(other.handle_, 0)),
        framebuffer_(std::exchange(other.framebuffer_, 0)) {}
  DumbBuffer& operator=(DumbBuffer&&) = delete;
  ~DumbBuffer();

  std::uint32_t framebuffer() const noexcept { return framebuffer_; }

 private:
  DumbBuffer(int fd, std::uint32_t handle) noexcept : fd_(fd), handle_(handle) {}

  int fd_;
  std::uint32_t handle_;
  std::uint32_t framebuffer_ = 0;
};

}  // namespace docent::kms
