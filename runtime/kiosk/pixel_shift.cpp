#include "runtime/kiosk/pixel_shift.h"

namespace docent::kiosk {
namespace {

constexpr std::int32_t side = 4;        ///< Of the square, pixels.
constexpr double soonest_seconds = 60;  ///< Between two steps.
constexpr double latest_seconds = 300;  ///< When nothing changes for so long, nobody looks.

}  // namespace

void PixelShift::advance(double seconds, bool changes) noexcept {
  since_step_ += seconds;
  if (since_step_ < (changes ? soonest_seconds : latest_seconds)) return;
  since_step_ = 0;
  step_ = (step_ + 1) % (4 * side);
}

PixelOffset PixelShift::at() const noexcept {
  const std::int32_t along = static_cast<std::int32_t>(step_) % side;
  switch (step_ / side) {
    case 0:
      return {along, 0};
    case 1:
      return {side, along};
    case 2:
      return {side - along, side};
    default:
      return {0, side - along};
  }
}

}  // namespace docent::kiosk
