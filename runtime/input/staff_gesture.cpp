#include "runtime/input/staff_gesture.h"

namespace docent::input {

StaffGesture::Corner StaffGesture::corner_of(const Contact& contact) noexcept {
  const bool left = contact.x <= corner, right = contact.x >= 1 - corner;
  const bool top = contact.y <= corner, bottom = contact.y >= 1 - corner;
  if (top && left) return Corner::TopLeft;
  if (top && right) return Corner::TopRight;
  if (bottom && left) return Corner::BottomLeft;
  return bottom && right ? Corner::BottomRight : Corner::None;
}

bool StaffGesture::is_diagonal() const noexcept {
  if (!one_ || !other_ || others_ > 0) return false;
  const auto are = [&](Corner a, Corner b) {
    return (one_->corner == a && other_->corner == b) || (one_->corner == b && other_->corner == a);
  };
  return are(Corner::TopLeft, Corner::BottomRight) || are(Corner::TopRight, Corner::BottomLeft);
}

void StaffGesture::take(const InputEvent& event, double time) noexcept {
  const bool was_diagonal = is_diagonal();
  const std::uint32_t id = event.contact.id;
  switch (event.kind) {
    case InputEvent::Kind::Down:
      if (!one_)
        one_ = Finger{id, corner_of(event.contact)};
      else if (!other_)
        other_ = Finger{id, corner_of(event.contact)};
      else
        ++others_;
      break;
    case InputEvent::Kind::Move:
      // A finger that has left its corner has to be put down anew.
      for (std::optional<Finger>* finger : {&one_, &other_})
        if (*finger && (*finger)->id == id && (*finger)->corner != corner_of(event.contact))
          (*finger)->corner = Corner::None;
      break;
    case InputEvent::Kind::Up:
    case InputEvent::Kind::Cancel:
      if (one_ && one_->id == id)
        one_.reset();
      else if (other_ && other_->id == id)
        other_.reset();
      else if (others_ > 0)
        --others_;
      break;
    default:
      return;
  }
  if (is_diagonal() == was_diagonal) return;
  since_ = time;
  told_ = false;
}

bool StaffGesture::is_made(double time) noexcept {
  if (told_ || !is_diagonal() || time - since_ < seconds) return false;
  told_ = true;
  return true;
}

}  // namespace docent::input
