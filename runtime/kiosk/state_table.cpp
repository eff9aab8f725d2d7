#include "runtime/kiosk/state_table.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>
#include <numbers>

namespace docent::kiosk {
namespace {

std::string_view name_of(guide::AvatarState state) noexcept {
  switch (state) {
    case guide::AvatarState::Turn:
      return "turn";
    case guide::AvatarState::Walk:
      return "walk";
    case guide::AvatarState::Wait:
      return "wait";
    case guide::AvatarState::Look:
      return "look";
    case guide::AvatarState::Gesture:
      return "gesture";
    case guide::AvatarState::Idle:
      break;
  }
  return "idle";
}

}  // namespace

void StateTable::add(double time, const guide::Guide& guide) {
  for (std::uint32_t i = 0; i < guide.crowd().size(); ++i) {
    const guide::Agent& one = guide.crowd()[i];
    if (!one.is_here) continue;
    const guide::Avatar& avatar = one.avatar;
    const double turned = std::remainder(avatar.body.heading, 2 * std::numbers::pi);
    fmt::format_to(std::back_inserter(csv_), "{:.4f},{},{:.4f},{:.4f},{:.2f},{}\n", time, i,
                   avatar.body.position.x, avatar.body.position.y, turned * 180 / std::numbers::pi,
                   name_of(guide.state_of(i)));
  }
}

}  // namespace docent::kiosk
