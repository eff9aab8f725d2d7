#pragma once

#include <chrono>

#include "runtime/kiosk/allocations.h"
#include "runtime/kiosk/statistics.h"

namespace docent::kiosk {

/// Measures one frame of the frame thread, from its construction on: CPU time by phase, and
/// allocations. The calls mark where a phase ends, in this order.
class FrameWatch {
 public:
  FrameWatch() noexcept;

  void stepped() noexcept;   ///< Touches are taken, the guide's state is advanced.
  void uploaded() noexcept;  ///< Texture memory is as the draw list needs it.
  void listed() noexcept;    ///< The draw list is made.
  /// All is done. `is_drawn`: the frame was drawn. `is_usual`: it entered no view, so that its
  /// allocations count.
  void end(bool is_drawn, bool is_usual, Statistics& statistics) noexcept;

 private:
  Allocations before_, made_{};
  std::chrono::nanoseconds begun_, stepped_{}, uploaded_{}, listed_{};
};

}  // namespace docent::kiosk
