#include "runtime/input/silence.h"

#include <algorithm>
#include <cmath>

namespace docent::input {
namespace {

/// A share of the glass: a finger that rests trembles less than this.
constexpr float same_place = 0.01F;

bool all_rest(std::span<const Contact> before, std::span<const Contact> now) noexcept {
  return !now.empty() && std::ranges::equal(before, now, [](const Contact& a, const Contact& b) {
    return a.id == b.id && a.x == b.x && a.y == b.y;
  });
}

}  // namespace

void Silence::heard(std::span<const Contact> before, std::span<const Contact> now,
                    std::chrono::nanoseconds time) noexcept {
  last_ = time;
  if (lifted_count_ > 0 && before.empty() && !now.empty()) learn_from_return(now);
  if (all_rest(before, now) && ++repetitions_ >= proof) reports_always_ = true;
}

/// The first touch after a silence: is it a finger that was never gone?
void Silence::learn_from_return(std::span<const Contact> now) noexcept {
  const auto was_lifted = [&](const Contact& c) {
    return std::ranges::any_of(std::span(lifted_).first(lifted_count_), [&](const Contact& old) {
      return c.id == old.id && std::abs(c.x - old.x) < same_place &&
             std::abs(c.y - old.y) < same_place;
    });
  };
  rests_silently_ |= std::ranges::any_of(now, was_lifted);
  lifted_count_ = 0;
}

bool Silence::lifts(std::span<const Contact> down, std::chrono::nanoseconds time) noexcept {
  if (down.empty() || !reports_always() || time - last_ < limit) return false;
  lifted_count_ = std::min(down.size(), lifted_.size());
  std::ranges::copy(down.first(lifted_count_), lifted_.begin());
  return true;
}

}  // namespace docent::input
