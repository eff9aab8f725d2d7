#pragma once

#include "runtime/input/contact.h"

namespace docent::input {

/// Leaves out a press of the same key too soon after the last, as a trembling hand makes it
/// (EN 301 549, clause 5.8). Another key in between is always taken.
class SameKey {
 public:
  /// Seconds from a press that was taken; 0: none is left out.
  explicit SameKey(double delay) noexcept : delay_(delay) {}

  /// Is the event one to be taken? `time`: of the event, seconds, never smaller than before.
  bool takes(const InputEvent& event, double time) noexcept {
    if (event.kind != InputEvent::Kind::KeyDown) return true;
    const bool is_same = event.key == key_ && event.character == character_;
    if (is_same && time - taken_ < delay_) return false;
    key_ = event.key;
    character_ = event.character;
    taken_ = time;
    return true;
  }

 private:
  double delay_;
  double taken_ = 0;
  Key key_ = Key::None;
  char character_ = 0;
};

}  // namespace docent::input
