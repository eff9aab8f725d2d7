#pragma once

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/guide/avatar.h"
#include "runtime/guide/proximity.h"
#include "runtime/model/museum.h"
#include "runtime/model/none.h"
#include "runtime/plan/planner.h"

namespace docent::guide {

/// One of a crowd: its avatar, where it wants to go, and how it gets on.
struct Agent {
  Avatar avatar;
  bool is_here = false;  ///< It appears once there is room for it.
  bool is_away = false;  ///< It has left, and comes only when it is told to appear.
  /// Where it appears, on which floor, if not where it is.
  std::optional<Placement> appears_at{};
  std::uint32_t appears_on = 0;
  std::optional<Placement> goal;  ///< Where it is sent; empty: it stands, or stops.
  std::uint32_t goal_floor = 0;
  std::optional<std::uint32_t> exhibit{};  ///< It was sent to see that.
  std::optional<PlaceKind> seeks{};        ///< It was sent to the nearest place of that kind, ...
  std::uint32_t place = none;              ///< ... which is this one, once that is known.
  RouteKind kind = RouteKind::Shortest;
  path::Permissions permissions{};
  double rank = 0;  ///< Whose wish is more urgent may ask others to make room.
  double pace = 1;  ///< Share of the ordinary speed.
  bool has_arrived = true;
  bool is_on_its_way = false;  ///< Its plan leads to its goal, and not aside for somebody else.
  std::optional<Placement> stops_at{};  ///< On its way it stands there first, until it is to go on.
  bool is_diverted = false;             ///< Its plan leads there, and not to its goal.
  bool awaits_answer = false;
  bool replans = false;  ///< It was under way when something closed or opened.
  bool boards = false;   ///< It has asked for a ride, or has been given one that it is not yet on.
  double boards_at = 0;  ///< Crowd's clock: when its wait at a stop is over; 0: none has begun.
  bool has_ridden = false;     ///< Since it was sent.
  bool is_answered = false;    ///< In this step, by a plan that begins a way.
  double blocked_seconds = 0;  ///< For how long others have been in its way.

  std::uint64_t last_order = 0;
  std::uint64_t commitments = 0;   ///< Plans that it has taken so far.
  std::uint64_t surroundings = 0;  ///< A hash: who was near when it last asked, with which plans.
  double ask_at = 0;  ///< Crowd's clock: it asks no earlier, unless its surroundings change ...
  double ask_again_at = 0;       ///< ... and then no earlier than this.
  double asked_for_room = -1e9;  ///< Crowd's clock: when it was last asked to make room.
  std::optional<std::uint32_t> made_room_for;  ///< It lets this agent go first, ...
  double let_first_until = 0;                  ///< ... until then (crowd's clock) at the latest.
  double lead = 0.25;  ///< Seconds between asking for a plan and the frame where it takes over.
  std::optional<interface::RouteSummary>
      route_summary;  ///< Of the way to its goal, once it is planned.
};

/// All agents of a building. A step finds who is near whom, asks the planner for walks in good
/// time, follows them, and asks those who hold up others to make room. An agent that is blocked, or
/// walks towards a stop that others have forced on it, asks again as soon as somebody near has
/// come, gone or changed plans. Nobody ever walks into anybody: the planner gives no such walk.
/// Right of way goes by rank, which grows while an agent is held up, so that nobody waits for ever.
///
/// Called by the frame thread. add() allocates; nothing else throws, allocates or waits.
class Crowd {
 public:
  Crowd(const Museum& museum, plan::Planner& planner);

  /// Adds an agent, which appears at that place as soon as there is room, and returns its number.
  /// There may be as many as the planner was made for. `pace`: share of the ordinary speed.
  std::uint32_t add(std::uint32_t floor, const Placement& place, double rank, double pace);

  /// Gives an agent a look from the next frame on: an index into `looks` (runtime/scene/look.h).
  void set_look(std::uint32_t who, std::uint32_t look) noexcept {
    members_[who].avatar.look = look;
  }
  /// Whom and what a body attends to, from the next step on.
  void attend(std::uint32_t who, const Company& company) noexcept {
    members_[who].avatar.company = company;
  }
  /// Wherever it is and whatever it does, it goes out of sight and appears at that place, standing,
  /// as soon as there is room. What it is told meanwhile it does from there.
  void appear(std::uint32_t who, std::uint32_t floor, const Placement& place) noexcept;
  /// It is gone at once, and takes no part in anything until it is told to appear.
  void leave(std::uint32_t who) noexcept;
  /// A hand of it is on something from the next step on, until it is told otherwise.
  void hold(std::uint32_t who, Side side, const std::optional<Held>& held) noexcept {
    members_[who].avatar.manner.held[index_of(side)] = held;
  }
  /// It lifts a hand to its visitor in the next step, whatever it does.
  void greet(std::uint32_t who) noexcept { guide::greet(members_[who].avatar.manner); }
  /// The same, to somebody there (world frame).
  void wave(std::uint32_t who, Vec3 whom) noexcept { wave_to(whom, members_[who].avatar.manner); }
  /// Who stands does not breathe, from now on; for all who were added.
  void hold_still() noexcept;
  /// Who is on a connection between two floors comes out first. `exhibit`: what one sees from the
  /// goal; while it is closed there is no way.
  void send(std::uint32_t who, std::uint32_t floor, const Placement& goal, RouteKind kind,
            const path::Permissions& permissions = {},
            std::optional<std::uint32_t> exhibit = {}) noexcept;
  /// To the nearest place of that kind.
  void seek(std::uint32_t who, PlaceKind place, RouteKind kind,
            const path::Permissions& permissions = {}) noexcept;
  /// What is closed has changed: whoever is under way asks for a new way, and stops where there is
  /// none.
  void replan() noexcept;
  /// Is it on the last part of the way to its goal, and nothing else is being found out for it?
  bool is_about_to_arrive(std::uint32_t who) const noexcept;
  /// Who is about to arrive ends there instead; where that cannot be, at its goal.
  void end_at(std::uint32_t who, const Placement& place) noexcept;
  /// Who is on its way walks to a place near it first and stands there, until it is to go on or is
  /// told something else. Its way is still that to its goal, and it has not arrived meanwhile.
  void stop_over(std::uint32_t who, const Placement& place) noexcept;
  void go_on_from_stop(std::uint32_t who) noexcept;
  /// Is it on its way, alone on its plan, and not between floors? Then it can stop over.
  bool can_stop_over(std::uint32_t who) const noexcept;
  /// Until it stands where it was to stop over; many where that is not known yet.
  double seconds_to_stop(std::uint32_t who) const noexcept;
  /// Does it stand there?
  bool stands_over(std::uint32_t who) const noexcept;
  /// Can a disc go straight from there to there, for all that walls do?
  bool is_clear(std::uint32_t floor, Vec2 from, Vec2 to, double radius) const noexcept;
  /// Has a disc room among the walls there?
  bool has_room(std::uint32_t floor, Vec2 place, double radius) const noexcept;
  /// It stops as soon as is natural.
  void stop(std::uint32_t who) noexcept;
  void step(double seconds) noexcept;

  /// How many overlaps there are now, as Proximity counts them: 0, unless something is wrong.
  std::size_t collisions() const noexcept;
  std::size_t size() const noexcept { return members_.size(); }
  /// How many more can be added.
  std::size_t room() const noexcept {
    return planner_.avatars() - std::min(planner_.avatars(), members_.size());
  }
  const Agent& operator[](std::uint32_t who) const noexcept { return members_[who]; }
  const std::vector<Agent>& members() const noexcept { return members_; }
  /// Seconds since the beginning.
  double clock() const noexcept { return clock_; }

 private:
  bool is_company() const noexcept { return members_.size() - away_ > 1; }
  void set_out(std::uint32_t who) noexcept;
  void take_answers() noexcept;
  void take_answer(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept;
  void take_ride(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept;
  void take_appearance(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept;
  void ask_for_next(std::uint32_t who) noexcept;
  void go_on(std::uint32_t who) noexcept;
  plan::WalkOrder order_of(const Agent& one) const noexcept;
  void take_stop_over(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept;
  void ask_for_ride(std::uint32_t who) noexcept;
  const plan::Nearby& near(std::uint32_t who) const noexcept;
  void ask(std::uint32_t who, plan::WalkOrder order, double takes_over) noexcept;
  bool yields(const Agent& one) const noexcept;
  std::uint64_t surroundings_of(std::uint32_t who) const noexcept;
  bool may_ask(std::uint32_t who) const noexcept;
  void ask_for_room(std::uint32_t who, std::uint32_t for_whom) noexcept;

  const Museum& museum_;
  plan::Planner& planner_;
  std::vector<Proximity> proximity_;  ///< Per floor.
  std::vector<Agent> members_;
  std::size_t away_ = 0;  ///< How many have left.
  std::uint64_t last_order_ = 0;
  double clock_ = 0;
};

/// Is it here, or about to be where it stands already?
bool is_to_be_seen(const Agent& one) noexcept;

/// Is it on a connection, or about to be? Then it comes out on the other floor, whatever it is
/// told.
bool is_between_floors(const Agent& one) noexcept;

/// Has the avatar come to the end of its plan, whether that leads to its goal or not?
bool stands(const Avatar& avatar) noexcept;

}  // namespace docent::guide
