#pragma once

#include <array>
#include <cstddef>

#include "platform/display.h"

namespace docent::kiosk {

/// How finely the model is drawn while the camera moves, so that pictures come often enough: where
/// a frame of all of it takes too long, as on a processor without a GPU, fewer pixels of it are
/// drawn and enlarged. The interface always has the screen's own pixels, and so has the model once
/// the camera rests.
class Fineness {
 public:
  /// Shares of the screen's lines and columns, finest first.
  static constexpr std::array shares{1.0F, 0.75F, 0.5F, 0.375F, 0.25F, 0.1875F};

  float share() const noexcept { return shares[step_]; }
  /// A frame of all of the model, drawn with share(), was followed by the next after so many
  /// seconds; `screen` says how far it may be made coarser: to 400 lines.
  void took(double seconds, PixelSize screen) noexcept;

 private:
  void move_to(std::size_t step) noexcept;

  static constexpr std::size_t looked_at = 4;
  std::array<double, looked_at> recent_{};  ///< Seconds that the last frames of this step took.
  std::size_t count_ = 0;                   ///< Of all frames of this step.
  std::size_t step_ = 0;                    ///< Which of the shares.
  std::size_t patience_ = 0;  ///< Frames that have to be quick until a finer one is tried.
};

}  // namespace docent::kiosk
