#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/motion/walk.h"
#include "runtime/motion/walk_graph.h"
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

/// What an avatar is asked to do.
struct WalkOrder {
  std::uint64_t id = 0;
  std::uint32_t floor = 0;
  RouteKind kind = RouteKind::Shortest;
  std::optional<Placement> goal;  ///< Empty: stop as soon as is natural.
  Placement start;                ///< Where the avatar stands if no plan is in progress.
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
};

/// A way and the walk along it: what the worker answers. Immutable once made.
///
/// A long way is walked in stretches, so that the avatar sets out at once and memory does not grow
/// with the way. The walk of a stretch ends standing after some metres, but before that, at
/// `handover_frame`, the next stretch of the same way takes over (an order that `continues`).
struct Plan {
  WalkOrder order;
  path::RouteStatus status = path::RouteStatus::NoRoute;
  double length = 0;                 ///< Metres of the way.
  std::vector<Vec2> points;          ///< The way, simplified to 2 mm, floor frame.
  std::vector<double> reach;         ///< Metres along the way of each point.
  motion::Walk walk;                 ///< At least one frame unless status says there is no way.
  bool is_whole = true;              ///< Does the walk lead to the goal?
  std::uint32_t handover_frame = 0;  ///< Where the next stretch takes over, unless is_whole.
  double seconds_to_goal = 0;        ///< From the walk's beginning; of later stretches a guess.
  bool is_new_way = false;           ///< `points` are not those of the plan before.
  bool holds = false;  ///< Others are in the way: there is no new walk, the old one goes on.
  std::vector<std::uint32_t> in_the_way;  ///< Avatars that should be asked to make room.

  double seconds() const noexcept {
    return walk.root.empty() ? 0 : static_cast<double>(walk.root.size() - 1) / walk.frame_rate;
  }
};

/// The point `metres` along a plan's way, clamped to its ends.
Vec2 point_along(const Plan& plan, double metres) noexcept;

/// Finds a way and makes a walk along it. Where the motion graph cannot walk (a museum compiled
/// without motion), the body glides along the way instead, so the guide still leads there.
/// `walking` is the museum's motion graph made ready; null where it has none or cannot walk.
std::unique_ptr<Plan> make_plan(const Museum& museum, const motion::WalkGraph* walking,
                                const path::FloorMap& map, const WalkOrder& order);

/// A plan of one frame: standing at a place.
std::unique_ptr<Plan> make_standing(const motion::WalkGraph* walking, const Placement& place);
std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place);

inline constexpr double glide_rate = 60;  ///< Frames a second of a body without motion.
/// A walk without a body: turns on the spot, then moves along `path` at walking pace with smooth
/// starts and stops.
motion::Walk glide(const Placement& start, std::span<const Vec2> path,
                   std::optional<double> final_heading);

}  // namespace docent::plan
