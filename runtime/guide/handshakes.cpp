#include "runtime/guide/handshakes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/guide/stature.h"

namespace docent::guide {
namespace {

constexpr double hands_apart = 0.72;   ///< Metres between two who shake hands, as large as life...
constexpr double bodies_apart = 0.12;  ///< ... and between their circles.
constexpr double elbow_room = 0.12;    ///< Metres more than their circle, from walls and others.
constexpr double off_by = 0.05;        ///< Metres by which they may stand nearer, or further...
constexpr double facing = 0.98;        ///< ... and cosine of what they may look past each other.
constexpr double patience = 45;        ///< Seconds for which they try to come together.
constexpr double shaken_for = 1.5;     ///< Seconds.
constexpr double parting_for = 0.5;    ///< Seconds.
constexpr double shakes_a_second = 2.2;
constexpr double looks_again_after = 0.5;  ///< Seconds, at a wish that could not be granted.
constexpr float shake_height = 0.02F;      ///< Metres, up and down.
constexpr float hand_height = 0.72F;       ///< Share of the shoulders' height.
constexpr float half_a_hand = 0.004F;      ///< Metres between a palm's middle and where they touch.
constexpr double near_each_other = 3.5;    ///< Metres, from where on they look at each other.

Vec2 direction(double heading) noexcept {
  return {std::cos(heading), std::sin(heading)};
}

bool is_free(const path::FloorMap& map, double radius, Vec2 place,
             std::span<const Vec2> others) noexcept {
  return map.has_room(place, radius + elbow_room) && std::ranges::all_of(others, [&](Vec2 other) {
           return glm::distance(place, other) > 2 * radius + elbow_room;
         });
}

Vec3 eyes_of(const Museum& museum, const Avatar& avatar) noexcept {
  const JointIndex head = museum.motion.skeleton[BodyPart::Head];
  if (head != JointIndex::None && index_of(head) < avatar.world.size())
    return Vec3(avatar.world[index_of(head)][3]);
  return to_world(avatar.body.position, avatar.height + 1.55);
}

float shoulder_height(const Avatar& avatar) noexcept {
  const auto& arm = avatar.limbs.arms[Side::Right];
  if (!arm) return 1.4F;
  return Vec3(avatar.world[arm->joint[arm->shoulder]][3]).y - static_cast<float>(avatar.height);
}

bool is_there(const Agent& one) noexcept {
  return one.has_arrived && !one.awaits_answer && stands(one.avatar);
}

/// Do their hands meet? Who is held up for long is content nearby, and has arrived there.
bool are_face_to_face(const Placement& one, const Placement& other, double apart) noexcept {
  const Vec2 line = other.position - one.position;
  const double length = glm::length(line);
  return std::abs(length - apart) < off_by &&
         glm::dot(direction(one.heading), line) > facing * length &&
         glm::dot(direction(other.heading), -line) > facing * length;
}

bool has_no_way(const Agent& one) noexcept {
  return one.route_summary && one.route_summary->status != path::RouteStatus::Ok;
}

}  // namespace

std::optional<std::array<Placement, 2>> meeting_place(const path::FloorMap& map, double radius,
                                                      double apart,
                                                      const std::array<Placement, 2>& bodies,
                                                      std::span<const Vec2> others) noexcept {
  constexpr int turns = 12, parts = 10;
  const Vec2 a = bodies[0].position, b = bodies[1].position;
  const double straight = std::atan2(b.y - a.y, b.x - a.x);
  std::optional<std::array<Placement, 2>> best;
  double least = 1e9;
  const auto consider = [&](Vec2 middle, double heading) {
    const Vec2 half = 0.5 * apart * direction(heading);
    const Vec2 first = middle - half, second = middle + half;
    if (!is_free(map, radius, first, others) || !is_free(map, radius, second, others) ||
        !map.walls().capsule_clear(first, second, 0.1))
      return;
    double cost = 0.3 * std::abs(std::remainder(heading - straight, 2 * std::numbers::pi));
    for (const auto& [from, to] : {std::pair{a, first}, std::pair{b, second}}) {
      cost += glm::distance(from, to);
      if (!map.walls().capsule_clear(from, to, radius)) cost += 5;  // it may be a long way round
    }
    if (cost >= least) return;
    least = cost;
    best = {Placement{first, heading}, Placement{second, heading + std::numbers::pi}};
  };
  for (int turn = 0; turn < turns; ++turn) {
    const double heading = straight + turn * 2 * std::numbers::pi / turns;
    for (int part = 0; part <= parts; ++part)
      consider(glm::mix(a, b, static_cast<double>(part) / parts), heading);
    // Where one of them stands already.
    consider(a + 0.5 * apart * direction(heading), heading);
    consider(b - 0.5 * apart * direction(heading), heading);
  }
  return best;
}

float DrawnSize::of(const Avatar& avatar) const noexcept {
  return of(to_world(avatar.body.position, avatar.height));
}

float DrawnSize::of(Vec3 ground) const noexcept {
  return is_enlarged ? stature_scale(camera, shape, ground) : 1;
}

Handshakes::Handshakes(const Museum& museum) : museum_(museum) {
  shakes_.reserve(interface::most_seats / 2);
  wishes_.resize(1 + interface::most_seats);
  others_.reserve(256);
}

void Handshakes::wish(std::size_t session, std::uint32_t guide, std::span<Session> sessions,
                      const DrawnSize& size, const plan::Planner& planner, Crowd& crowd) noexcept {
  if (session >= wishes_.size() || !sessions[session].guide()) return;
  const auto whose = std::ranges::find(sessions, std::optional(guide), &Session::guide);
  if (whose == sessions.end()) return;
  const auto other = static_cast<std::size_t>(whose - sessions.begin());
  const std::uint32_t own = *sessions[session].guide();
  if (other == session) return;
  crowd.wave(own, eyes_of(museum_, crowd[guide].avatar));
  wishes_[session] = {.of = other, .own = own, .guide = guide, .left = wished_for};
  const bool both_wish = wishes_[other].of == session && wishes_[other].left > 0;
  if (sessions[other].is_under_way() && !both_wish) return;
  wishes_[session].is_due = true;
  wishes_[session].rests = looks_again_after;
  if (begin(session, other, sessions, size, planner, crowd))
    wishes_[session].left = wishes_[other].left = 0;
}

bool Handshakes::begin(std::size_t one, std::size_t other, std::span<Session> sessions,
                       const DrawnSize& size, const plan::Planner& planner, Crowd& crowd) noexcept {
  if (!sessions[one].can_meet() || !sessions[other].can_meet() ||
      shakes_.size() == shakes_.capacity())
    return false;
  const std::array guide{*sessions[one].guide(), *sessions[other].guide()};
  const Avatar &a = crowd[guide[0]].avatar, &b = crowd[guide[1]].avatar;
  if (a.floor != b.floor || a.floor >= planner.maps().size()) return false;
  others_.clear();
  for (std::uint32_t who = 0; who < crowd.size() && others_.size() < others_.capacity(); ++who)
    if (const Agent& it = crowd[who];
        who != guide[0] && who != guide[1] && it.is_here && it.avatar.floor == a.floor)
      others_.push_back(it.avatar.body.position);
  const double radius = museum_.body_radius;
  const double apart = std::max(hands_apart * static_cast<double>(0.5F * (size.of(a) + size.of(b))),
                                2 * radius + bodies_apart);
  const auto places =
      meeting_place(*planner.maps()[a.floor], radius, apart, {a.body, b.body}, others_);
  if (!places) return false;
  sessions[one].meet((*places)[0]);
  sessions[other].meet((*places)[1]);
  shakes_.push_back({.session = {one, other}, .guide = guide, .apart = apart});
  return true;
}

/// In time, and as soon as either visitor has gone: whoever sits there now has wished nothing.
void Handshakes::forget_wishes(double seconds, std::span<const Session> sessions) noexcept {
  for (std::size_t k = 0; k < sessions.size() && k < wishes_.size(); ++k) {
    Wish& wish = wishes_[k];
    wish.left = std::max(0.0, wish.left - seconds);
    if (wish.left > 0 &&
        (sessions[k].guide() != wish.own || sessions[wish.of].guide() != wish.guide))
      wish.left = 0;
  }
}

/// Who had something in hand when it was wished may be free now.
void Handshakes::grant_wishes(double seconds, std::span<Session> sessions, const DrawnSize& size,
                              const plan::Planner& planner, Crowd& crowd) noexcept {
  for (std::size_t k = 0; k < sessions.size() && k < wishes_.size(); ++k) {
    Wish& wish = wishes_[k];
    if (wish.left <= 0 || !wish.is_due) continue;
    wish.rests -= seconds;
    if (wish.rests > 0) continue;
    wish.rests = looks_again_after;
    if (sessions[k].is_under_way() || sessions[wish.of].is_under_way()) continue;
    if (!begin(k, wish.of, sessions, size, planner, crowd)) continue;
    wish.left = 0;
    if (wishes_[wish.of].of == k) wishes_[wish.of].left = 0;
  }
}

void Handshakes::step(double seconds, std::span<Session> sessions, const DrawnSize& size,
                      const plan::Planner& planner, Crowd& crowd) noexcept {
  forget_wishes(seconds, sessions);
  grant_wishes(seconds, sessions, size, planner, crowd);
  for (Handshake& it : shakes_) {
    it.since += seconds;
    const auto both = [&](auto is) { return is(0) && is(1); };
    const bool goes_on = both([&](std::size_t k) {
      return sessions[it.session[k]].guide() == it.guide[k] && sessions[it.session[k]].is_meeting();
    });
    const auto next = [&](Handshake::Phase phase) { it.phase = phase, it.since = 0; };
    switch (it.phase) {
      case Handshake::Phase::Coming:
        if (!goes_on || it.since > patience ||
            !both([&](std::size_t k) { return !has_no_way(crowd[it.guide[k]]); }))
          next(Handshake::Phase::Parting);
        else if (both([&](std::size_t k) { return is_there(crowd[it.guide[k]]); }))
          next(are_face_to_face(crowd[it.guide[0]].avatar.body, crowd[it.guide[1]].avatar.body,
                                it.apart)
                   ? Handshake::Phase::Together
                   : Handshake::Phase::Parting);
        break;
      case Handshake::Phase::Together:
        // Who is asked to make room for somebody lets go.
        if (!goes_on || it.since > motion::longest_change + shaken_for ||
            !both([&](std::size_t k) { return stands(crowd[it.guide[k]].avatar); }))
          next(Handshake::Phase::Parting);
        break;
      case Handshake::Phase::Parting:
        break;
    }
    if (it.phase == Handshake::Phase::Together) shake(it, size, crowd);
    if (it.phase == Handshake::Phase::Parting && it.since == 0)
      for (const std::uint32_t guide : it.guide) crowd.hold(guide, Side::Right, {});
    if (it.phase == Handshake::Phase::Parting && it.since > parting_for)
      for (std::size_t k = 0; k < 2; ++k)
        if (sessions[it.session[k]].guide() == it.guide[k]) sessions[it.session[k]].part();
    for (std::size_t k = 0; k < 2; ++k) {
      const Avatar &one = crowd[it.guide[k]].avatar, &other = crowd[it.guide[1 - k]].avatar;
      Company company = one.company;
      company.exhibit = company.passer = {};
      if (goes_on && glm::distance(one.body.position, other.body.position) < near_each_other)
        company.partner = eyes_of(museum_, other);
      crowd.attend(it.guide[k], company);
    }
  }
  std::erase_if(shakes_, [](const Handshake& it) {
    return it.phase == Handshake::Phase::Parting && it.since > parting_for;
  });
}

/// Right hands meet between the two as they are drawn, thumbs up, and go up and down together.
void Handshakes::shake(const Handshake& it, const DrawnSize& size, Crowd& crowd) const noexcept {
  const double shaking = it.since - motion::longest_change;
  float up = 0;  // above the ground, as drawn
  for (const std::uint32_t guide : it.guide) {
    const Avatar& one = crowd[guide].avatar;
    up += 0.5F * hand_height * size.of(one) * build_of(one) * shoulder_height(one);
  }
  if (shaking > 0) {
    const double eased = std::min(1.0, 4 * std::min(shaking, std::max(0.0, shaken_for - shaking)));
    up += shake_height *
          static_cast<float>(eased * std::sin(2 * std::numbers::pi * shakes_a_second * shaking));
  }
  const Vec2 middle =
      0.5 * (crowd[it.guide[0]].avatar.body.position + crowd[it.guide[1]].avatar.body.position);
  for (const std::uint32_t guide : it.guide) {
    const Avatar& one = crowd[guide].avatar;
    const Vec2 line = middle - one.body.position;
    const double length = glm::length(line);
    if (length < 0.1) return;
    const Vec2 ahead = line / length;
    const Vec2 right{ahead.y, -ahead.x};
    const auto scale = static_cast<double>(size.of(one));
    const Vec2 at = one.body.position + (line + static_cast<double>(half_a_hand) * right) / scale;
    crowd.hold(
        guide, Side::Right,
        Held{{.place = to_world(at, one.height) + Vec3{0, up / (size.of(one) * build_of(one)), 0},
              .fingers = to_world(ahead),
              .thumb = {0, 1, 0}},
             it.since});
  }
}

}  // namespace docent::guide
