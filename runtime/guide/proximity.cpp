#include "runtime/guide/proximity.h"

#include <algorithm>

#include "runtime/guide/crowd.h"
#include "runtime/path/floor_map.h"

namespace docent::guide {
namespace {

constexpr double touching = 0.01;  // metres a radius: so much may be lost to a walk's rounding

}  // namespace

Proximity::Proximity(const path::FloorMap& map, std::uint32_t floor, double body_radius,
                     std::size_t most)
    : map_(map),
      floor_(floor),
      body_radius_(body_radius),
      near_(most),
      last_(most),
      was_here_(most, false) {
  if (most > 1) meetings_.emplace(map, most);
  bodies_.reserve(most);
  agent_.reserve(most);
}

void Proximity::look(std::span<const Agent> agents, double seconds) noexcept {
  bodies_.clear();
  agent_.clear();
  collisions_ = 0;
  const double radius = body_radius_ - touching;
  for (std::uint32_t i = 0; i < std::min(agents.size(), near_.size()); ++i) {
    near_[i].count = 0;
    const Agent& one = agents[i];
    const bool is_here =
        one.is_here && one.avatar.floor == floor_ && ride_of(one.avatar) == nullptr;
    const Vec2 place = one.avatar.body.position;
    if (is_here) {
      const bool moved = was_here_[i] && seconds > 0;
      bodies_.push_back({place, moved ? (place - last_[i]) / seconds : Vec2{}, near_reach / 2});
      agent_.push_back(i);
      if (map_.clearance_at(place) < radius) ++collisions_;
    }
    was_here_[i] = is_here;
    last_[i] = place;
  }
  if (!meetings_) return;
  meetings_->update(bodies_);
  for (const crowd::Meeting& meeting : meetings_->find(near_horizon)) {
    near_[agent_[meeting.a]].add(agent_[meeting.b], meeting.time);
    near_[agent_[meeting.b]].add(agent_[meeting.a], meeting.time);
    const Vec2 apart = bodies_[meeting.b].position - bodies_[meeting.a].position;
    if (dot(apart, apart) <= 4 * radius * radius) ++collisions_;
  }
}

}  // namespace docent::guide
