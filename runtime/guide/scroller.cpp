#include "runtime/guide/scroller.h"

#include <algorithm>
#include <cmath>

namespace docent::guide {
namespace {

constexpr float glide_seconds = 0.28F;
constexpr float drag_run_seconds = 0.3F;  ///< In which speed falls to a third.
constexpr float slow = 0.02F;             ///< Nobody sees that it still moves.
constexpr float fastest = 3;              ///< Screens a second.

}  // namespace

void Scroller::enter(const interface::ScrollArea& area, bool is_same) noexcept {
  if (!is_same || !area.exists()) {
    *this = Scroller(reduced_motion_);
    return;
  }
  offset_ = std::clamp(offset_, 0.0F, area.most());
  to_ = std::clamp(to_, 0.0F, area.most());
}

void Scroller::hold(const input::Contact& at) noexcept {
  if (finger_) return;  // one is enough
  finger_ = at.id;
  start_ = last_ = at.y;
  drags_ = false;
  speed_ = moved_ = 0;
}

bool Scroller::drag(const interface::ScrollArea& area, const input::Contact& at,
                    float slack) noexcept {
  if (finger_ != at.id) return false;
  if (!drags_ && std::abs(at.y - start_) < slack) return false;
  if (!drags_) last_ = at.y;  // it begins here, without a leap
  drags_ = true;
  glides_ = false;
  const float before = offset_;
  offset_ = std::clamp(offset_ + last_ - at.y, 0.0F, area.most());
  moved_ += offset_ - before;
  last_ = at.y;
  return true;
}

void Scroller::let_go(std::uint32_t finger) noexcept {
  if (finger_ != finger) return;
  finger_.reset();
  if (!drags_ || reduced_motion_) speed_ = 0;
  drags_ = false;
}

void Scroller::turn(const interface::ScrollArea& area, int pages) noexcept {
  const float at = glides_ ? to_ : offset_;
  go_to(std::clamp(at + static_cast<float>(pages) * area.page, 0.0F, area.most()));
}

void Scroller::go_to(float offset) noexcept {
  speed_ = 0;
  if (offset == offset_ && !glides_) return;
  if (reduced_motion_) {
    offset_ = offset;
    return;
  }
  from_ = offset_;
  to_ = offset;
  glide_ = 0;
  glides_ = true;
}

void Scroller::advance(const interface::ScrollArea& area, float seconds) noexcept {
  if (seconds <= 0) return;
  if (glides_) {
    glide_ = std::min(1.0F, glide_ + seconds / glide_seconds);
    const float left = 1 - glide_;
    offset_ = std::lerp(from_, to_, 1 - left * left * left);
    glides_ = glide_ < 1;
    return;
  }
  if (finger_) {  // as fast as it goes, without what its hand trembles
    speed_ = std::clamp(std::lerp(speed_, moved_ / seconds, 0.4F), -fastest, fastest);
    moved_ = 0;
    return;
  }
  if (speed_ == 0) return;
  offset_ += speed_ * seconds;
  speed_ *= std::exp(-seconds / drag_run_seconds);
  const float most = area.most();
  if (offset_ <= 0 || offset_ >= most || std::abs(speed_) < slow) speed_ = 0;
  offset_ = std::clamp(offset_, 0.0F, most);
}

}  // namespace docent::guide
