#pragma once

#include <cstdint>

namespace docent::kiosk {

/// Pixels to the right and down.
struct PixelOffset {
  std::int32_t x = 0, y = 0;
  bool operator==(const PixelOffset&) const = default;
};

/// Lets the picture wander, so that what always stands at one place does not burn in: by one pixel
/// at a time, round a square of four pixels, in a frame in which the picture changes anyway.
class PixelShift {
 public:
  /// `changes`: the whole picture is another in this frame, so that a step is not seen.
  void advance(double seconds, bool changes) noexcept;
  PixelOffset at() const noexcept;

 private:
  double since_step_ = 0;
  std::uint32_t step_ = 0;
};

}  // namespace docent::kiosk
