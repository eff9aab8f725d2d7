#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/guide/avatar.h"
#include "runtime/guide/proximity.h"
#include "runtime/model/museum.h"
#include "runtime/plan/planner.h"

namespace docent::guide {

/// One of a crowd: who walks, where to, and how that goes.
struct Agent {
  Avatar avatar;
  bool is_here = false;           ///< Not before there is room for it.
  std::optional<Placement> goal;  ///< Where it is wanted; empty: nowhere, it stands or stops.
  RouteKind kind = RouteKind::Shortest;
  double rank = 0;  ///< Whose wish is more urgent may ask others to make room.
  double pace = 1;  ///< Share of the ordinary speed.
  bool has_arrived = true;
  bool is_on_its_way = false;  ///< Its plan leads to its goal (and not aside, for somebody else).
  bool awaits_answer = false;
  bool is_answered = false;    ///< In this step, by a plan that begins a way.
  double blocked_seconds = 0;  ///< For how long others have been in its way.

  std::uint64_t last_order = 0;
  std::uint64_t commitments = 0;   ///< Plans that it has taken so far.
  std::uint64_t surroundings = 0;  ///< Who was near when it last asked, and what they were up to.
  double ask_at = 0;  ///< Crowd's clock: no earlier than that, unless its surroundings change ...
  double ask_again_at = 0;  ///< ... and then no earlier than that.
  double asked_for_room = -1e9;
  std::optional<std::uint32_t> made_room_for;  ///< And lets that one go first, ...
  double let_first_until = 0;                  ///< ... but no longer than until then.
  double lead = 0.25;  ///< Seconds ahead from which the next plan is asked for.
  std::optional<interface::RouteSummary>
      route_summary;  ///< Of the way to its goal, once it is planned.
};

/// All who walk on a floor: says in each step who is or soon will be near whom, asks the planner
/// for their walks in good time, follows them, and sees to it that who holds up others makes room.
/// Whoever is blocked, or walks towards a stop that others have forced on it, asks anew as soon as
/// somebody near has come, gone or changed plans. Nobody ever walks into anybody: the planner gives
/// no such walk. Right of way goes by rank, which grows while one is held up, so that nobody waits
/// for ever.
///
/// Called by the frame thread. add() allocates; nothing else throws, allocates or waits.
class Crowd {
 public:
  Crowd(const Museum& museum, plan::Planner& planner);

  /// Somebody who shall stand there; appears as soon as there is room. As many as the planner
  /// knows.
  std::uint32_t add(std::uint32_t floor, const Placement& place, double rank, double pace);

  /// From the next frame on it has that look, of `looks` (runtime/scene/look.h).
  void set_look(std::uint32_t who, std::uint32_t look) noexcept {
    members_[who].avatar.look = look;
  }
  void send(std::uint32_t who, const Placement& goal, RouteKind kind) noexcept;
  /// It stops as soon as is natural.
  void stop(std::uint32_t who) noexcept;
  void step(double seconds) noexcept;

  /// How many touch another or a wall now: none, unless something is wrong.
  std::size_t collisions() const noexcept { return proximity_ ? proximity_->collisions() : 0; }
  std::size_t size() const noexcept { return members_.size(); }
  const Agent& operator[](std::uint32_t who) const noexcept { return members_[who]; }
  const std::vector<Agent>& members() const noexcept { return members_; }
  /// Seconds since the beginning.
  double clock() const noexcept { return clock_; }

 private:
  void take_answers() noexcept;
  void take_answer(Agent& one, std::unique_ptr<plan::Plan> plan) noexcept;
  void ask_for_next(std::uint32_t who) noexcept;
  void ask(std::uint32_t who, plan::WalkOrder order, double takes_over) noexcept;
  bool yields(const Agent& one) const noexcept;
  std::uint64_t surroundings_of(std::uint32_t who) const noexcept;
  bool may_ask(std::uint32_t who) const noexcept;
  void ask_for_room(std::uint32_t who, std::uint32_t for_whom) noexcept;

  const Museum& museum_;
  plan::Planner& planner_;
  std::optional<Proximity> proximity_;  ///< Of the kiosk's floor; none where there is none.
  std::vector<Agent> members_;
  std::uint64_t last_order_ = 0;
  double clock_ = 0;
};

/// Has it come to the end of its plan, whether that leads to its goal or not?
bool stands(const Avatar& avatar) noexcept;

}  // namespace docent::guide
