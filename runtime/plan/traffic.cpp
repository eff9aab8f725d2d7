#include "runtime/plan/traffic.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "runtime/crowd/find_detour.h"
#include "runtime/crowd/find_passage.h"
#include "runtime/crowd/find_refuge.h"
#include "runtime/interface/goal.h"
#include "runtime/model/geometry/polyline.h"
#include "runtime/motion/path_track.h"
#include "runtime/plan/care.h"
#include "runtime/plan/lead_through_doors.h"
#include "runtime/plan/leg.h"
#include "runtime/plan/stretch.h"

namespace docent::plan {
namespace {

constexpr double spare = 0.01;          // metres between two bodies that pass each other
constexpr double least_advance = 0.4;   // metres that are worth to set out for
constexpr double meeting_margin = 1.0;  // seconds before a meeting by which a body stands
constexpr double start_seconds = 0.6;   // that a start takes longer than walking on
constexpr double turning_rate = 1.2;    // radians a second, by steps on the spot
constexpr double way_behind_reach = 3;  // metres
constexpr double about_it = 1.5;        // metres: who stands so near may be in the way of a way out
constexpr double patience = 3;          // seconds before another way round is looked for
constexpr double wall_spare = 0.008;    // metres by which a circle may be in a wall
constexpr double endless = 1e9;         // metres
constexpr std::size_t frames_apart = 6;  // of the walk behind a body, between looks at its place
constexpr int most_attempts = 4;

/// Where a plan's walk leads its body, from some seconds of it on.
void append_trajectory(const motion::Walk& walk, double from, double seconds,
                       crowd::Trajectory& trajectory) {
  const auto last = static_cast<double>(walk.body.size() - 1);
  for (double t = from; t < from + seconds; t += crowd::Trajectory::step) {
    const double at = std::clamp(t * walk.frame_rate, 0.0, last);
    const auto f = static_cast<std::size_t>(at);
    const std::size_t next = std::min(f + 1, walk.body.size() - 1);
    trajectory.place.push_back(
        glm::mix(walk.body[f].position, walk.body[next].position, at - static_cast<double>(f)));
  }
}

/// The plan in progress, from a second before the new one would take over.
crowd::Trajectory trajectory_before(const WalkOrder& order) {
  constexpr double before = 1;
  const motion::Walk& walk = order.previous->walk;
  crowd::Trajectory trajectory{seconds_of(order) - before, {}};
  const double left = order.previous->seconds() - order.previous_seconds;
  append_trajectory(walk, order.previous_seconds - before,
                    before + std::max(0.0, left) + crowd::Trajectory::step, trajectory);
  return trajectory;
}

double length_in_seconds(const motion::Walk& walk) {
  return walk.body.empty() ? 0 : static_cast<double>(walk.body.size() - 1) / walk.frame_rate;
}

bool stands(const WalkOrder& order) {
  return order.previous == nullptr || order.previous_seconds >= order.previous->seconds() - 1e-6;
}

/// What is left of the way of the plan before, joined slantwise by a body that has been beside it.
std::vector<Vec2> rest_of_way(const path::FloorMap& map, const WalkOrder& order, double radius) {
  const Plan& before = *order.previous;
  std::vector<Vec2> rest = way_ahead(before, order.previous_frame);
  if (rest.empty() || before.walk.along.empty()) return rest;
  const double along =
      before.walk.along[std::min<std::size_t>(order.previous_frame, before.walk.along.size() - 1)];
  const double beside = glm::distance(rest.front(), point_along(before, along));
  if (beside < 0.05) return rest;
  for (const double ahead : {3 * beside, 1.5 * beside}) {
    const Vec2 joint = point_along(before, along + ahead);
    if (!map.walls().capsule_clear(rest.front(), joint, radius)) continue;
    std::vector<Vec2> joined{rest.front(), joint};
    for (std::size_t i = 0; i < before.points.size(); ++i)
      if (before.reach[i] > along + ahead + 0.02) joined.push_back(before.points[i]);
    return joined;
  }
  return rest;
}

/// The way that a body has come on, from where it is.
std::vector<Vec2> way_behind(const WalkOrder& order) {
  std::vector<Vec2> behind;
  if (order.previous == nullptr) return behind;
  const motion::Walk& walk = order.previous->walk;
  double length = 0;
  for (std::size_t f = std::min<std::size_t>(order.previous_frame, walk.body.size() - 1);;) {
    const Vec2 here = walk.body[f].position;
    if (behind.empty() || glm::distance(behind.back(), here) > 0.1) {
      if (!behind.empty()) length += glm::distance(behind.back(), here);
      behind.push_back(here);
    }
    if (f == 0 || length > way_behind_reach) break;
    f -= std::min(f, frames_apart);
  }
  return behind;
}

/// Metres walked told as metres of the way.
void tell_along_way(std::span<const double> reach, std::span<const double> along, double done,
                    motion::Walk& walk) {
  for (float& walked : walk.along) {
    const auto after = std::ranges::upper_bound(reach, static_cast<double>(walked));
    const auto i = static_cast<std::size_t>(after - reach.begin());
    double here = along.front();
    if (i >= reach.size())
      here = along.back();
    else if (i > 0)
      here = std::lerp(along[i - 1], along[i], (walked - reach[i - 1]) / (reach[i] - reach[i - 1]));
    walked = static_cast<float>(std::max(0.0, done + here));
  }
}

/// Corners of the passage's grid that are hardly any are left out.
std::vector<Vec2> straightened(std::span<const Vec2> points) {
  std::vector<Vec2> out;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (i > 0 && i + 1 < points.size() && !out.empty()) {
      const Vec2 a = points[i] - out.back(), b = points[i + 1] - points[i];
      if (glm::length(a) > 1e-9 && glm::length(b) > 1e-9 &&
          std::abs(cross(a, b)) < 0.02 * glm::length(a) * glm::length(b) && dot(a, b) > 0)
        continue;
    }
    out.push_back(points[i]);
  }
  return out;
}

}  // namespace

Traffic::Traffic(const Museum& museum, const motion::WalkGraph* walking,
                 const path::BuildingMap& building, std::uint32_t floor)
    : museum_(museum),
      walking_(walking),
      building_(building),
      map_(building.floor(floor)),
      reservations_(museum.body_radius) {}

void Traffic::leave(std::uint32_t body, double when) {
  leaving_[body] = when;
}

/// Those who have left by now.
void Traffic::let_go(double now) {
  std::erase_if(leaving_, [&](const auto& one) {
    if (one.second > now) return false;
    reservations_.remove(one.first);
    members_.erase(one.first);
    return true;
  });
}

bool Traffic::keep_place(const WalkOrder& order, Vec2 place, Plan& plan) {
  const double now = seconds_of(order);
  let_go(now);
  leaving_.erase(order.avatar);
  const crowd::Trajectory there = crowd::standing_trajectory(place);
  const auto conflict = reservations_.first_conflict(order.avatar, there, spare, now);
  Member& member = members_[order.avatar];
  member.rank = order.rank;
  member.line = {place};
  if (!conflict) {
    reservations_.put(order.avatar, there);
    return true;
  }
  if (members_[conflict->body].rank < never_yields) plan.in_the_way.push_back(conflict->body);
  return false;
}

/// To the nearest place of a kind.
std::unique_ptr<Plan> Traffic::seek(const WalkOrder& order) {
  const FoundPlace found = find_place(museum_, building_, order, takes_over_at(order).position);
  WalkOrder there = order;
  there.seeks.reset();
  if (found.status == path::RouteStatus::Ok) {
    const Place& place = museum_.places[found.place];
    there.goal = interface::standing_at(place);
    there.goal_floor = place.floor;
    auto plan = this->plan(there);
    plan->place = found.place;
    return plan;
  }
  auto plan = std::make_unique<Plan>();
  plan->order = there;
  plan->status = found.status;
  plan->hindrance = found.hindrance;
  plan->place = found.place;
  return plan;
}

std::unique_ptr<Plan> Traffic::plan(const WalkOrder& order) {
  if (order.seeks) return seek(order);
  let_go(seconds_of(order));
  leaving_.erase(order.avatar);
  members_[order.avatar].rank = order.rank;
  if (order.enters) return enter(order);
  auto plan = order.makes_room_for ? make_room(order) : order.goal ? get_on(order) : stop(order);
  // Whatever had been given it since, it goes on as before now.
  if (plan->holds && order.previous != nullptr)
    reservations_.put(order.avatar, trajectory_before(order));
  return plan;
}

std::vector<std::uint32_t> Traffic::yields_when_asked(const WalkOrder& order) const {
  std::vector<std::uint32_t> out;
  for (const auto& [id, member] : members_)
    if (id != order.avatar && member.rank < order.rank) out.push_back(id);
  return out;
}

std::unique_ptr<Plan> Traffic::enter(const WalkOrder& order) {
  auto plan = make_standing(walking_, order.start);
  plan->order = order;
  const crowd::Trajectory here = crowd::standing_trajectory(order.start.position);
  plan->holds =
      reservations_.first_conflict(order.avatar, here, spare, seconds_of(order)).has_value();
  if (!plan->holds) reservations_.put(order.avatar, here);
  return plan;
}

std::optional<crowd::Conflict> Traffic::commit(Plan& plan, motion::Walk walk) {
  const WalkOrder& order = plan.order;
  // What it does until then stays as it was; that it has been committed to already.
  constexpr double before = 1;
  crowd::Trajectory trajectory;
  trajectory.start = seconds_of(order) - before;
  if (order.previous != nullptr)
    append_trajectory(order.previous->walk, order.previous_seconds - before, before - 1e-9,
                      trajectory);
  else
    trajectory.place.assign(static_cast<std::size_t>(before / crowd::Trajectory::step),
                            order.start.position);
  append_trajectory(walk, 0, length_in_seconds(walk) + crowd::Trajectory::step, trajectory);
  auto meeting = reservations_.first_conflict(order.avatar, trajectory, spare, seconds_of(order));
  if (const auto wall = first_wall(trajectory, seconds_of(order));
      wall && (!meeting || *wall < meeting->seconds))
    meeting = crowd::Conflict{*wall, order.avatar};
  if (meeting) return meeting;
  reservations_.put(order.avatar, std::move(trajectory));
  plan.walk = std::move(walk);
  return {};
}

std::optional<double> Traffic::first_wall(const crowd::Trajectory& trajectory, double from) const {
  // Who stands nearer to a wall than it may has to get away from it.
  const double room =
      std::min(museum_.body_radius, map_.clearance_at(crowd::place_at(trajectory, from)));
  for (double t = from; t < trajectory.end(); t += crowd::Trajectory::step)
    if (!map_.has_room(crowd::place_at(trajectory, t), room - wall_spare)) return t;
  return {};
}

std::unique_ptr<Plan> Traffic::stop(const WalkOrder& order) {
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = path::RouteStatus::Ok;
  motion::Walk walk = walk_along(walking_, order, takes_over_at(order), {}, {});
  plan->holds = commit(*plan, std::move(walk)).has_value();
  plan->seconds_to_goal = plan->seconds();
  return plan;
}

std::unique_ptr<Plan> Traffic::make_room(const WalkOrder& order) {
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  plan->status = path::RouteStatus::Ok;
  const Placement from = takes_over_at(order);
  const std::vector<Vec2> line = members_[*order.makes_room_for].line;
  constexpr std::size_t most_refuges = 5;
  for (const crowd::Refuge& refuge :
       crowd::find_refuges(map_, reservations_, order.avatar, from.position, line, most_refuges)) {
    motion::Walk walk = walk_along(walking_, order, from, refuge.way, {});
    if (commit(*plan, std::move(walk))) continue;
    plan->length = polyline_length(refuge.way);
    keep_way(refuge.way, *plan);
    plan->seconds_to_goal = plan->seconds();
    return plan;
  }
  // Others stand about it: they have to make room for the same line first.
  plan->holds = true;
  members_[order.avatar].line = line;
  for (const crowd::ReservationTable::Entry& entry : reservations_.entries())
    if (entry.body != order.avatar && entry.body != *order.makes_room_for &&
        entry.trajectory.end() <= seconds_of(order) && members_[entry.body].rank < never_yields &&
        glm::distance(entry.trajectory.place.back(), from.position) < about_it)
      plan->in_the_way.push_back(entry.body);
  return plan;
}

std::unique_ptr<Plan> Traffic::get_on(const WalkOrder& order) {
  auto plan = std::make_unique<Plan>();
  plan->order = order;
  const Placement from = takes_over_at(order);
  std::vector<Vec2> way;
  double done = 0;
  if (order.continues && order.previous != nullptr && !order.previous->reach.empty()) {
    const Plan& before = *order.previous;
    plan->status = before.status;
    plan->length = before.length;
    plan->points = before.points;
    plan->reach = before.reach;
    plan->end = before.end;
    plan->then = before.then;
    plan->metres_after = before.metres_after;
    plan->seconds_after = before.seconds_after;
    way = rest_of_way(map_, order, museum_.body_radius);
    done = plan->reach.back() - polyline_length(way);
  } else {
    Leg leg = find_leg(museum_, building_, order, from.position);
    plan->status = leg.way.status;
    plan->hindrance = leg.hindrance;
    if (leg.way.status != path::RouteStatus::Ok) return plan;
    plan->end = leg.end;
    plan->then = leg.then;
    plan->metres_after = leg.metres_after;
    plan->seconds_after = leg.seconds_after;
    way = lead_through_doors(museum_, map_, leg.way.points);
    const double longer = polyline_length(way) - polyline_length(leg.way.points);
    plan->length = leg.way.length + longer + leg.metres_after;
    keep_way(way, *plan);
    plan->is_new_way = true;
  }
  if (way.size() < 2) way = {from.position, plan->end.position};
  if (advance(*plan, from, way, done)) return plan;
  if (order.blocked_seconds > patience && plan->in_the_way.empty()) {
    const path::RouteQuery query{.kind = RouteKind::Shortest,
                                 .from = from.position,
                                 .to = plan->end.position,
                                 .radius = museum_.body_radius + Museum::walking_room,
                                 .tell_clearance = false};
    path::Way round =
        crowd::find_detour(map_, reservations_, order.avatar, query, seconds_of(order));
    if (round.status == path::RouteStatus::Ok) {
      plan->length = round.length + plan->metres_after;
      keep_way(round.points, *plan);
      plan->is_new_way = true;
      if (advance(*plan, from, round.points, 0)) return plan;
    }
  }
  plan->holds = true;
  return plan;
}

/// All of the way, or the first stretch of a long one; less where a turn would lead into a wall.
bool Traffic::walk_alone(Plan& plan, const Placement& from, std::span<const Vec2> way,
                         double done) {
  const double length = polyline_length(way);
  double most = length > stretch_length + least_rest ? stretch_length : endless;
  for (int attempt = 0; attempt < most_attempts && most > least_advance; ++attempt) {
    const bool arrives = most >= length;
    const std::vector<Vec2> points =
        arrives ? std::vector<Vec2>(way.begin(), way.end()) : first_part(way, most);
    std::optional<double> facing;
    if (arrives) facing = plan.end.heading;
    motion::Walk walk =
        walk_along(walking_, plan.order, from, points, facing, careful_places(museum_, plan));
    for (float& along : walk.along) along += static_cast<float>(done);
    if (commit(plan, std::move(walk))) {
      most = std::min(most, length) / 2;
      continue;
    }
    end_walk(arrives, plan);
    const bool stands_before = plan.handover_frame + 1 == motion::frame_count(plan.walk);
    if (arrives || most < stretch_length || !stands_before) return true;
    most = endless;  // no place where another stretch could take over: all of it
  }
  return !plan.walk.root.empty();
}

bool Traffic::advance(Plan& plan, const Placement& from, std::span<const Vec2> way, double done) {
  const WalkOrder& order = plan.order;
  if (!order.seconds) {
    plan.seconds_to_goal = seconds_along(plan, way);
    return walk_alone(plan, from, way, done);
  }
  const std::span<const std::uint32_t> detected = order.near.agents();
  std::vector<std::uint32_t> near(detected.begin(), detected.end());
  const auto is_looked_at = [&near](std::uint32_t body) {
    return std::ranges::find(near, body) != near.end();
  };
  for (;;) {
    const crowd::Passage passage = find_passage(order, from, way, near);
    members_[order.avatar].line = passage.line;
    plan.in_the_way = passage.in_the_way;
    plan.seconds_to_goal = seconds_along(plan, way);
    const std::optional<std::uint32_t> met = walk(plan, {from, way, done, passage, near});
    if (!met) return true;
    // Who was far away when it was asked, and is met on the way, is looked at as well.
    if (*met == order.avatar || is_looked_at(*met)) return false;
    near.push_back(*met);
  }
}

/// A guess, with what it takes longer where it takes care.
double Traffic::seconds_along(const Plan& plan, std::span<const Vec2> way) const {
  const double speed = speed_of(plan.order);
  return polyline_length(way) / speed + seconds_of_care(careful_places(museum_, plan), way, speed) +
         plan.seconds_after;
}

double Traffic::speed_of(const WalkOrder& order) const noexcept {
  return order.pace * (walking_ != nullptr ? walking_->speed : 1.0);
}

crowd::Passage Traffic::find_passage(const WalkOrder& order, const Placement& from,
                                     std::span<const Vec2> way,
                                     std::span<const std::uint32_t> near) const {
  crowd::PassageQuery query;
  query.body = order.avatar;
  query.seconds = seconds_of(order);
  query.way = way;
  query.speed = speed_of(order);
  query.near = near;
  const Vec2 ahead = first_part(way, 0.5).back() - from.position;
  if (stands(order)) {
    const double turn =
        std::abs(std::remainder(std::atan2(ahead.y, ahead.x) - from.heading, 2 * std::numbers::pi));
    query.delay = start_seconds + (turn > 0.5 ? turn / turning_rate + 0.5 : 0);
  }
  const std::vector<Vec2> behind = way_behind(order);
  query.behind = behind;
  const std::vector<std::uint32_t> yields = yields_when_asked(order);
  query.yields_when_asked = yields;
  return crowd::find_passage(map_, reservations_, query);
}

motion::Walk Traffic::walk_to(const Plan& plan, const Advance& advance, std::uint32_t stop) const {
  const crowd::Passage& passage = advance.passage;
  const bool arrives = passage.reaches_goal && stop + 1 == passage.points.size();
  std::vector<Vec2> points = straightened(std::span(passage.points).first(std::size_t{stop} + 1));
  // On the way itself its own bends are walked and not those of the passage's steps.
  if (passage.is_straight)
    points = arrives ? std::vector<Vec2>(advance.way.begin(), advance.way.end())
                     : first_part(advance.way, passage.along[stop]);
  std::optional<double> facing;
  if (arrives) facing = plan.end.heading;
  return walk_along(walking_, plan.order, advance.from, points, facing,
                    careful_places(museum_, plan));
}

std::optional<std::uint32_t> Traffic::walk(Plan& plan, const Advance& advance) {
  const WalkOrder& order = plan.order;
  const crowd::Passage& passage = advance.passage;
  const std::vector<double> reach = distances_along(passage.points);
  // As far as it may go at once; where somebody would be met after all, less far.
  double most =
      passage.reaches_goal && reach.back() < stretch_length + least_rest ? endless : stretch_length;
  for (int attempt = 0; attempt < most_attempts; ++attempt) {
    std::optional<std::uint32_t> stop;
    for (const std::uint32_t i : passage.stop)
      if (reach[i] <= most) stop = i;
    if (!stop) break;
    const bool arrives = passage.reaches_goal && *stop + 1 == passage.points.size();
    if (reach[*stop] < least_advance && !arrives) break;
    motion::Walk walk = walk_to(plan, advance, *stop);
    const std::vector<double> walked(walk.along.begin(), walk.along.end());
    if (!passage.is_straight)
      tell_along_way(reach, passage.along, advance.done, walk);
    else
      for (float& along : walk.along) along += static_cast<float>(advance.done);
    const std::optional<crowd::Conflict> conflict = commit(plan, std::move(walk));
    if (!conflict) {
      end_walk(arrives, plan);
      return {};
    }
    if (conflict->body != order.avatar &&
        std::ranges::find(advance.near, conflict->body) == advance.near.end())
      return conflict->body;
    const double seconds = conflict->seconds - meeting_margin - seconds_of(order);
    const auto frame = static_cast<std::size_t>(
        std::max(0.0, seconds * (walking_ != nullptr ? walking_->frame_rate : glide_rate)));
    most = frame < walked.size() && seconds > 0 ? std::min(walked[frame], reach[*stop] - 0.2)
                                                : reach[*stop] * 0.5;
  }
  return order.avatar;
}

void Traffic::end_walk(bool arrives, Plan& plan) const {
  plan.is_whole = arrives;
  if (arrives) {
    plan.seconds_to_goal = plan.seconds() + plan.seconds_after;
    return;
  }
  plan.handover_frame = motion::frame_count(plan.walk) - 1;
  if (walking_ != nullptr)
    if (const auto frame = find_handover_frame(museum_.motion, plan.walk))
      plan.handover_frame = *frame;
}

}  // namespace docent::plan
