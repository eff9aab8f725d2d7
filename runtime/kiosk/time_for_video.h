#pragma once

#include <array>
#include <cstddef>

namespace docent::kiosk {

/// Has a machine time to draw bodies that move beside a video of 24 frames a second? One with a
/// graphics processor has; where a processor draws, a guide near the camera takes the time of
/// several frames. It is known from whatever was drawn before the video began.
class TimeForVideo {
 public:
  /// A frame of which only bodies, and perhaps some of the interface, were drawn anew was followed
  /// by the next after so many seconds.
  void took(double seconds) noexcept;
  bool is_short() const noexcept { return is_short_; }

 private:
  static constexpr std::size_t looked_at = 4;
  std::array<double, looked_at> recent_{};  ///< Seconds that the last of them took.
  std::size_t count_ = 0;
  bool is_short_ = false;
};

}  // namespace docent::kiosk
