#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "platform/display.h"

namespace docent::gles {

/// Fetches one drawn frame from the driver without waiting for it: asked for in one frame, there in
/// a later one. For the frame thread, with its context current from construction to destruction.
class ReadBack {
 public:
  ReadBack() = default;
  ~ReadBack() { end(); }
  ReadBack(const ReadBack&) = delete;
  ReadBack& operator=(const ReadBack&) = delete;

  /// Asks for what was drawn into a framebuffer (0: the window's) of this size, before it is
  /// presented.
  void begin(std::uint32_t framebuffer, PixelSize size) noexcept;
  bool is_begun() const noexcept { return buffer_ != 0; }
  PixelSize size() const noexcept { return size_; }
  /// Four bytes a pixel, red first, rows from the bottom; empty until they have come. Any thread
  /// may read them until end().
  std::span<const std::byte> take() noexcept;
  void end() noexcept;

 private:
  PixelSize size_;
  std::uint32_t buffer_ = 0;
  void* drawn_ = nullptr;  ///< A fence.
  std::span<const std::byte> pixels_;
};

}  // namespace docent::gles
