#include "runtime/guide/chapters.h"

#include "runtime/model/exhibit/room_of.h"
#include "runtime/plan/plan.h"

namespace docent::guide {
namespace {

constexpr double look_every = 0.5;        ///< Metres of the way.
constexpr float look_again_after = 0.5F;  ///< Seconds.

}  // namespace

interface::Chapter next_chapter(const Museum& museum, const Avatar& leader) noexcept {
  using interface::Chapter;
  if (ride_of(leader) != nullptr) return Chapter::Floor;
  const plan::Plan& plan = *leader.plan;
  if (plan.points.size() < 2) return Chapter::Goal;
  const std::uint32_t here = room_of(museum, leader.floor, leader.body.position);
  for (double at = leader.along + look_every; at < plan.reach.back(); at += look_every) {
    const std::uint32_t room = room_of(museum, leader.floor, plan::point_along(plan, at));
    if (room != none && room != here) return Chapter::Room;
  }
  return plan.then ? Chapter::Floor : Chapter::Goal;
}

bool Chapters::has_ended(const Avatar& leader, std::uint32_t room) const noexcept {
  if (ride_of(leader) != nullptr) return false;
  return leader.floor != floor_ || (room != none && room != room_);
}

interface::InterfaceState Chapters::step(const interface::InterfaceState& state,
                                         const Avatar& leader, float seconds) noexcept {
  interface::InterfaceState now = state;
  const bool goes_along = state.screen == interface::Screen::Walking &&
                          state.glass == interface::Glass::Whole && state.pace > 0 &&
                          !state.arrived;
  since_looked_ += seconds;
  if (!goes_along) {
    now.skips = skips_ = false;
    since_looked_ = look_again_after;
    return now;
  }
  if (state.skips) {
    const std::uint32_t room = room_of(museum_, leader.floor, leader.body.position);
    if (!skips_) {
      floor_ = leader.floor;
      room_ = room;
    }
    now.skips = !has_ended(leader, room);
    if (!now.skips) since_looked_ = look_again_after;
  }
  skips_ = now.skips;
  if (since_looked_ < look_again_after) return now;
  since_looked_ = 0;
  now.next = next_chapter(museum_, leader);
  return now;
}

}  // namespace docent::guide
