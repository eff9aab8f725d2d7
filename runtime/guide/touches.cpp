#include "runtime/guide/touches.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "runtime/guide/exhibit_shape.h"
#include "runtime/interface/seats.h"

namespace docent::guide {
namespace {

constexpr double points_first = 3.4;  ///< Seconds from arrival.
constexpr double patience = 25;       ///< Seconds for which it tries to get there.
constexpr double parting_for = 0.5;   ///< Seconds.
constexpr double off_by = 0.03;       ///< Metres, and...
constexpr double off_turn = 0.06;     ///< ... radians by which it may stand otherwise.
/// Times as large as life: a body that is larger stands too near, and is only drawn so.
constexpr float most_enlarged = 1.1F;
constexpr float miss = 0.008F;      ///< Metres by which a palm may miss its place.
constexpr float is_turned = 0.02F;  ///< Radians by which a visitor has turned an object.

bool is_there(const Agent& one, const Placement& place) noexcept {
  const Placement& body = one.avatar.body;
  return glm::distance(body.position, place.position) < off_by &&
         std::abs(std::remainder(body.heading - place.heading, 2 * std::numbers::pi)) < off_turn;
}

bool has_no_way(const Agent& one) noexcept {
  return one.route_summary && one.route_summary->status != path::RouteStatus::Ok;
}

/// On which side of the line of sight it stands.
Side side_of(const Exhibit& exhibit, Vec2 middle, Vec2 stands) noexcept {
  const Vec2 view = exhibit.viewing_point.position;
  return cross(middle - view, stands - view) > 0 ? Side::Left : Side::Right;
}

/// How a body stands. Its arms' trunks are as they were posed last.
motion::Stance stance_of(const Skeleton& skeleton, const Avatar& avatar) noexcept {
  motion::Stance stance{.body = avatar.body, .height = avatar.height};
  for (const Side side : both_sides)
    if (const auto& arm = avatar.limbs.arms[side]) {
      const Mat4& trunk = avatar.world[index_of(arm->trunk)];
      stance.trunk[index_of(side)] = {Vec3(trunk[3]), glm::normalize(glm::quat_cast(trunk))};
    }
  if (const JointIndex spine = skeleton[BodyPart::Spine]; spine != JointIndex::None)
    stance.waist = Vec3(avatar.world[index_of(spine)][3]);
  return stance;
}

}  // namespace

Touches::Touches(const Museum& museum) : museum_(museum), visits_(1 + interface::most_seats) {}

/// Who has arrived, and pointed at it for a while, goes to touch it.
void Touches::begin(Session& session, Visit& visit, const DrawnSize& size,
                    const Crowd& crowd) const noexcept {
  const Agent& one = crowd[visit.guide];
  if (session.is_meeting() || !session.can_meet() || !stands(one.avatar) || !one.has_arrived ||
      session.table().angle() != 0)
    return;
  const Exhibit& exhibit = museum_.exhibits[visit.exhibit];
  const Side side = side_of(exhibit, exhibit.placement.position, one.avatar.body.position);
  const auto touch = std::ranges::find(exhibit.touches, side, &Touch::beside);
  visit.since = 0;
  visit.phase = Visit::Phase::Done;
  if (touch == exhibit.touches.end() ||
      size.of(to_world(touch->body.position, one.avatar.height)) > most_enlarged)
    return;
  visit.phase = Visit::Phase::Coming;
  visit.touch = *touch;
  session.meet(touch->body);
}

/// The grip as the body feels it that is drawn higher than its skeleton, and larger than life.
motion::Grip Touches::grip_of(const Visit& visit, const Avatar& avatar, const DrawnSize& size,
                              double seconds) const noexcept {
  motion::Grip grip = motion::grip_after(visit.touch, seconds);
  const float scale = size.of(avatar);
  const Vec3 ground = to_world(avatar.body.position, avatar.height);
  const Vec3 off = (grip.place - ground) / scale;
  grip.place = ground + Vec3{off.x, off.y / build_of(avatar), off.z};
  return grip;
}

bool Touches::is_in_reach(const Visit& visit, const Avatar& avatar,
                          const DrawnSize& size) const noexcept {
  const Side side = visit.touch.hand;
  const auto& arm = avatar.limbs.arms[side];
  if (!arm) return false;
  const Skeleton& skeleton = museum_.motion.skeleton;
  const motion::Stance stance = stance_of(museum_.motion.skeleton, avatar);
  const motion::JointPlace trunk = motion::leaned(stance, visit.touch.lean).trunk[index_of(side)];
  const motion::Grip grip = grip_of(visit, avatar, size, motion::touch_begins);
  const motion::ArmPosture posture = motion::holding(skeleton, *arm, trunk, grip);
  return glm::distance(motion::palm_of(skeleton, *arm, trunk, posture), grip.place) < miss;
}

void Touches::go_on(Session& session, Visit& visit, const DrawnSize& size,
                    Crowd& crowd) const noexcept {
  using Phase = Visit::Phase;
  const Agent& one = crowd[visit.guide];
  const auto next = [&](Phase phase) { visit.phase = phase, visit.since = 0; };
  const bool is_let_be = session.is_meeting() && session.table().angle() <= is_turned &&
                         session.table().angle() >= -is_turned;
  if (visit.phase == Phase::Coming) {
    if (!is_let_be || visit.since > patience || has_no_way(one))
      next(Phase::Parting);
    else if (one.has_arrived && !one.awaits_answer && stands(one.avatar))
      next(is_there(one, visit.touch.body) && is_in_reach(visit, one.avatar, size)
               ? Phase::Touching
               : Phase::Parting);
  } else if (visit.phase == Phase::Touching &&
             (!is_let_be || visit.since > motion::touch_seconds || !stands(one.avatar))) {
    next(Phase::Parting);
  }
  const Side side = visit.touch.hand;
  if (visit.phase == Phase::Touching)
    crowd.hold(visit.guide, side,
               Held{grip_of(visit, one.avatar, size, visit.since),
                    visit.since,
                    {.lean = motion::lean_after(visit.touch, visit.since)}});
  if (visit.phase == Phase::Parting) {
    if (visit.since == 0) crowd.hold(visit.guide, side, {});
    if (visit.since > parting_for || !session.is_meeting()) {
      session.part();
      next(Phase::Done);
    }
  }
  Company company = one.avatar.company;
  company.exhibit = company.passer = {};
  if (visit.phase == Phase::Touching) company.partner = visit.touch.palm;
  if (session.is_meeting()) crowd.attend(visit.guide, company);
}

void Touches::step(double seconds, std::span<Session> sessions, const DrawnSize& size,
                   Crowd& crowd) noexcept {
  using Phase = Visit::Phase;
  for (std::size_t k = 0; k < std::min(sessions.size(), visits_.size()); ++k) {
    Session& session = sessions[k];
    Visit& visit = visits_[k];
    visit.since += seconds;
    const interface::InterfaceState& state = session.state();
    const bool has_come = session.guide() && state.arrived && state.exhibit &&
                          *state.exhibit < museum_.exhibits.size();
    const bool is_same =
        has_come && visit.guide == *session.guide() && visit.exhibit == *state.exhibit;
    if (visit.phase != Phase::None && !is_same) {
      // Told something else: its hand comes away, and it goes where it is sent.
      if (visit.phase == Phase::Touching) crowd.hold(visit.guide, visit.touch.hand, {});
      visit.phase = Phase::None;
    }
    if (visit.phase == Phase::None && has_come) {
      const bool is_touched = !museum_.exhibits[*state.exhibit].touches.empty();
      visit = {.phase = is_touched ? Phase::Pointing : Phase::Done,
               .guide = *session.guide(),
               .exhibit = *state.exhibit,
               .touch = {}};
    }
    if (visit.phase == Phase::Pointing && visit.since > points_first)
      begin(session, visit, size, crowd);
    else if (visit.phase != Phase::None && visit.phase != Phase::Pointing &&
             visit.phase != Phase::Done)
      go_on(session, visit, size, crowd);
  }
}

}  // namespace docent::guide
