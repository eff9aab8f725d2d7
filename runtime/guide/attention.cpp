#include "runtime/guide/attention.h"

#include <algorithm>
#include <cmath>

#include "runtime/interface/goal.h"
#include "runtime/interface/seats.h"
#include "runtime/scene/camera.h"
#include "runtime/scene/side.h"

namespace docent::guide {
namespace {

constexpr double eye_height = 1.55;       ///< Metres.
constexpr double passes_near = 2.6;       ///< Metres between two who may wave to each other...
constexpr double in_view = 1.9;           ///< ... this far from straight ahead at most, radians.
constexpr double waves_back_after = 0.7;  ///< Seconds.

double floor_height(const Museum& museum, std::uint32_t floor) noexcept {
  return floor < museum.floors.size() ? museum.floors[floor].plan.height : 0;
}

Vec3 eyes_of(const Avatar& avatar) noexcept {
  return to_world(avatar.body.position, avatar.height + eye_height);
}

bool sees(const Avatar& one, const Avatar& other) noexcept {
  const Vec2 line = other.body.position - one.body.position;
  const double distance = glm::length(line);
  if (one.floor != other.floor || distance > passes_near || distance < 1e-3) return false;
  const Vec2 ahead{std::cos(one.body.heading), std::sin(one.body.heading)};
  return dot(ahead, line) > std::cos(in_view) * distance;
}

/// The nearest of `others` whom it sees and who `counts`.
template <typename Counts>
std::optional<Vec3> nearest_seen(const Agent& one, std::span<const Agent> others,
                                 const Counts& counts) noexcept {
  std::optional<Vec3> found;
  double nearest = passes_near;
  for (const Agent& other : others) {
    if (&other == &one || !other.is_here || !counts(other.avatar) ||
        !sees(one.avatar, other.avatar))
      continue;
    const double distance = glm::distance(one.avatar.body.position, other.avatar.body.position);
    if (distance > nearest) continue;
    nearest = distance;
    found = eyes_of(other.avatar);
  }
  return found;
}

bool walks(const Avatar& avatar) noexcept {
  return avatar.gait == motion::Gait::Walk;
}

bool has_waved(const Avatar& avatar) noexcept {
  const double since = avatar.manner.clock - avatar.manner.waved;
  return avatar.manner.gesture == motion::Gesture::Wave && since > waves_back_after;
}

}  // namespace

std::optional<Vec3> Attention::goal_of(const Session& session) const noexcept {
  if (!session.state().arrived) return {};
  if (session.state().exhibit && *session.state().exhibit < shapes_.size())
    return shapes_[*session.state().exhibit].middle;
  const auto goal = interface::goal_of(museum_, session.state());
  if (!goal) return {};
  return to_world(goal->position, floor_height(museum_, goal->floor) + eye_height - 0.3);
}

void Attention::direct(std::span<const Session> sessions, const interface::ScreenShape& shape,
                       const scene::CameraView& camera, std::size_t guides, bool calm,
                       Crowd& crowd) const noexcept {
  const std::vector<Agent>& all = crowd.members();
  const std::size_t count = std::min(guides, all.size());
  const std::span<const Agent> strollers = std::span(all).subspan(count);
  for (std::uint32_t who = 0; who < all.size(); ++who) {
    Company company{.calm = calm};
    if (who < count)
      company.passer = nearest_seen(all[who], strollers, walks);
    else
      company.passer = nearest_seen(all[who], std::span(all).first(count), has_waved);
    crowd.attend(who, company);
  }
  for (const Session& session : sessions) {
    if (!session.guide()) continue;
    const Avatar& avatar = all[*session.guide()].avatar;
    Company company = avatar.company;
    company.is_used = !session.is_vacant();
    company.exhibit = goal_of(session);
    company.visitor = camera.eye;
    if (const auto& seat = session.state().seat) {
      const scene::Rect card = interface::card_of(shape, session.state().seats, *seat);
      const scene::ScreenPoint middle =
          scene::to_screen(interface::side_of(shape, session.state()),
                           scene::ScreenPoint{card.x + card.width / 2, card.y + card.height / 2});
      company.visitor =
          scene::point_at_height(camera, middle, static_cast<float>(avatar.height + eye_height));
    }
    crowd.attend(*session.guide(), company);
  }
}

}  // namespace docent::guide
