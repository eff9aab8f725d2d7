#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/directions/doorways.h"
#include "runtime/interface/layout.h"
#include "runtime/model/museum.h"
#include "runtime/model/none.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"
#include "runtime/path/building/building_way.h"
#include "runtime/path/route.h"

namespace docent::plan {

struct Plan;

/// Whoever has this rank or a higher one is not asked to make room.
inline constexpr double never_yields = 1e6;

/// The agents that are near an agent, soonest first; of more than `most`, the first ones.
struct Nearby {
  static constexpr std::size_t most = 16;
  std::array<std::uint32_t, most> agent{};
  std::array<float, most> seconds{};  ///< From now.
  std::uint32_t count = 0;

  std::span<const std::uint32_t> agents() const noexcept { return std::span(agent).first(count); }
  void add(std::uint32_t other, double when) noexcept;
};

/// A journey by a connection, from one of its stops to another.
struct Ride {
  std::uint32_t connection = 0;    ///< Index into Museum::connections.
  std::uint32_t from = 0, to = 0;  ///< Indices into its stops.
  double wait = 0;                 ///< Seconds at the stop before.
  double seconds = 0;              ///< After the wait.
  double metres = 0;               ///< As walked.
};

/// What an avatar is asked to do.
struct WalkOrder {
  std::uint64_t id = 0;
  std::uint32_t floor = 0;
  RouteKind kind = RouteKind::Shortest;
  std::optional<Placement> goal;              ///< Empty: stop as soon as is natural.
  std::optional<std::uint32_t> goal_floor{};  ///< Where the goal is; empty: on `floor`.
  /// Instead of the goal, which is then anything: the nearest place of that kind, on any floor.
  std::optional<PlaceKind> seeks{};
  /// The goal is where one stands to see that: no way leads there while it is closed.
  std::optional<std::uint32_t> exhibit{};
  path::Permissions permissions{};  ///< Of the connections to other floors.
  Placement start;                  ///< Where the avatar stands if no plan is in progress.
  /// The plan in progress and the frame of its walk from which the new one takes over. Whoever asks
  /// keeps that plan until the answer to its latest order has come.
  const Plan* previous = nullptr;
  std::uint32_t previous_frame = 0;
  bool continues = false;  ///< The next stretch of the same way; goal and kind are as before.
  double pace = 1;         ///< Share of the ordinary speed, in (0, 1].
  std::uint32_t avatar = 0;

  /// Only where others walk too: when the new plan takes over, on the crowd's clock; and the same
  /// moment in seconds since the beginning of `previous`, which may have ended by then. Without,
  /// the others are not looked at.
  std::optional<double> seconds{};
  double previous_seconds = 0;
  double rank = 0;  ///< Whose wish is more urgent may ask others to make room.
  std::optional<std::uint32_t> makes_room_for{};  ///< Step aside to any refuge for that avatar.
  Nearby near{};               ///< As the crowd has found them; the plan looks at them first.
  double blocked_seconds = 0;  ///< For how long others have been in its way.
  bool enters = false;         ///< Appear at `start`, as soon as there is room.
  bool leaves = false;         ///< It is nowhere from now on. That has no answer.
  /// Leave the floor by that connection, from its stop, where the body stands, and come out on
  /// another; as soon as there is room there.
  std::optional<Ride> ride{};
};

/// A way and the walk along it: what the worker answers. Immutable once made.
///
/// A long way is walked in stretches, so that the avatar sets out at once and memory does not grow
/// with the way. The walk of a stretch ends standing after some metres, but before that, at
/// `handover_frame`, the next stretch of the same way takes over (an order that `continues`).
struct Plan {
  WalkOrder order;
  path::RouteStatus status = path::RouteStatus::NoRoute;
  std::optional<interface::Hindrance> hindrance{};  ///< No way, because of that.
  /// Of an order that seeks: the place that was found, which is the goal of `order` now; where
  /// there is no way, the one to which there would be one at best; `none` where there is no place.
  std::uint32_t place = none;
  double length = 0;                          ///< Metres to the goal, over floors and stairs.
  std::vector<Vec2> points;                   ///< The way, simplified to 2 mm, floor frame.
  std::vector<double> reach;                  ///< Metres along the way of each point.
  std::vector<directions::PassedDoor> doors;  ///< That the way leads through.
  motion::Walk walk;                 ///< At least one frame unless status says there is no way.
  bool is_whole = true;              ///< Does the walk lead to the end of the way?
  std::uint32_t handover_frame = 0;  ///< Where the next stretch takes over, unless is_whole.
  double seconds_to_goal = 0;        ///< From the walk's beginning; of later stretches a guess.
  /// Where the way ends: at the goal, or at the stop of the connection that is taken next.
  Placement end;
  std::optional<Ride> then{};                  ///< Taken at the end of the way.
  double metres_after = 0, seconds_after = 0;  ///< From there on, to the goal.
  double beyond = 0;  ///< Where it ends on the way, to go on: metres left on this floor from there.
  double rests_until = 0;  ///< Seconds from its beginning until it is over, if later than the walk.
  bool is_new_way = false;  ///< `points` are not those of the plan before.
  bool holds = false;       ///< Others are in the way: there is no new walk, the old one goes on.
  std::vector<std::uint32_t> in_the_way;  ///< Avatars that should be asked to make room.

  double seconds() const noexcept {
    const double walking =
        walk.root.empty() ? 0 : static_cast<double>(walk.root.size() - 1) / walk.frame_rate;
    return std::max(walking, rests_until);
  }
};

/// The point `metres` along a plan's way, clamped to its ends.
Vec2 point_along(const Plan& plan, double metres) noexcept;

/// A plan of one frame: standing at a place.
std::unique_ptr<Plan> make_standing(const motion::WalkGraph* walking, const Placement& place);
std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place);

inline constexpr double glide_rate = 60;  ///< Frames a second of a body without motion.
/// A walk without a body: turns on the spot, then moves along `path` at walking pace with smooth
/// starts and stops.
motion::Walk glide(const Placement& start, std::span<const Vec2> path,
                   std::optional<double> final_heading);

}  // namespace docent::plan
