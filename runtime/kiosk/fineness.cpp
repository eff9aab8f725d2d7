#include "runtime/kiosk/fineness.h"

#include <algorithm>

namespace docent::kiosk {
namespace {

/// Twenty pictures a second look like motion.
constexpr double longest = 1.0 / 20;
/// A finer picture is tried where it would leave so much of that, if frames cost by the pixel.
constexpr double spare = 0.8;
constexpr float least_lines = 400;
/// Frames that have to be quick before a finer picture is tried: the more, the more often that was
/// in vain, up to some minutes.
constexpr std::size_t first_patience = 60, most_patience = 7200;

bool is_allowed(float share, PixelSize screen) noexcept {
  return share * static_cast<float>(std::min(screen.width, screen.height)) >= least_lines;
}

}  // namespace

void Fineness::move_to(std::size_t step) noexcept {
  if (step > step_) patience_ = std::clamp(2 * patience_, first_patience, most_patience);
  step_ = step;
  count_ = 0;
}

void Fineness::took(double seconds, PixelSize screen) noexcept {
  recent_[count_++ % looked_at] = seconds;
  if (count_ < looked_at) return;
  // One that was held up by something else says nothing.
  const double quickest = *std::ranges::min_element(recent_);
  const std::size_t coarser = step_ + 1;
  if (quickest > longest) {
    if (coarser < shares.size() && is_allowed(shares[coarser], screen)) move_to(coarser);
    return;
  }
  if (step_ == 0 || count_ < patience_) return;
  const double slowest = *std::ranges::max_element(recent_);
  const double more = shares[step_ - 1] / shares[step_];
  if (slowest * more * more < spare * longest)
    move_to(step_ - 1);
  else
    count_ = looked_at;
}

}  // namespace docent::kiosk
