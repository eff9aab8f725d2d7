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

/// A rank from which on nobody is asked to make room.
inline constexpr double never_yields = 1e6;

/// Who is or soon will be near an agent, soonest first; of more than there is room for, the first.
struct Nearby {
  static constexpr std::size_t most = 16;
  std::array<std::uint32_t, most> agent{};
  std::array<float, most> seconds{};  ///< From now.
  std::uint32_t count = 0;

  std::span<const std::uint32_t> agents() const noexcept { return std::span(agent).first(count); }
  void add(std::uint32_t other, double when) noexcept;
};

/// What the guide is asked to do.
struct WalkOrder {
  std::uint64_t id = 0;
  std::uint32_t floor = 0;
  RouteKind kind = RouteKind::Shortest;
  std::optional<Placement> goal;  ///< Empty: stop as soon as is natural.
  Placement start;                ///< Where it stands, where there is no plan in progress.
  /// The plan in progress and the frame of its walk from which the new one takes over. Whoever asks
  /// keeps that plan until the answer to its latest order has come.
  const Plan* previous = nullptr;
  std::uint32_t previous_frame = 0;
  bool continues = false;  ///< The next stretch of the same way; goal and kind are as before.
  double pace = 1;         ///< Share of the ordinary speed, in (0, 1].
  std::uint32_t avatar = 0;

  /// Only where others walk too: when the new plan takes over, on the crowd's clock, and when
  /// that is on the clock of `previous` (which may have ended). Without, it takes over as soon as
  /// it can.
  std::optional<double> seconds{};
  double previous_seconds = 0;
  double rank = 0;  ///< Whose wish is more urgent may ask others to make room.
  std::optional<std::uint32_t> makes_room_for{};  ///< Step aside for that avatar, wherever.
  Nearby near{};               ///< As the crowd has detected it; the plan looks at them first.
  double blocked_seconds = 0;  ///< For how long others have been in its way.
  bool enters = false;         ///< Appear at `start`, as soon as there is room.
};

/// A way and the walk along it: what the worker answers. Immutable once made.
///
/// A long way is walked in stretches, so that the guide sets out at once and memory does not grow
/// with the way: the walk then ends standing after some metres, and before that, at
/// `handover_frame`, the next stretch takes over (an order that `continues`), with the same way.
struct Plan {
  WalkOrder order;
  path::RouteStatus status = path::RouteStatus::NoRoute;
  double length = 0;                 ///< Metres of the way.
  std::vector<Vec2> points;          ///< The way, simplified to 2 mm, floor frame.
  std::vector<double> reach;         ///< Metres along the way of each point.
  motion::Walk walk;                 ///< At least one frame unless status says there is no way.
  bool is_whole = true;              ///< Does the walk lead to the goal?
  std::uint32_t handover_frame = 0;  ///< Where it does not.
  double seconds_to_goal = 0;        ///< From the walk's beginning; where it goes on, at its pace.
  bool is_new_way = false;           ///< `points` are not those of the plan before.
  bool holds = false;  ///< Others are in the way: there is no walk now, the one before is kept.
  std::vector<std::uint32_t> in_the_way;  ///< Who could make room.

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

/// Standing at a place: a plan of one frame.
std::unique_ptr<Plan> make_standing(const motion::WalkGraph* walking, const Placement& place);
std::unique_ptr<Plan> make_standing(const Museum& museum, const Placement& place);

/// A walk without a body: turns on the spot, then moves along `path` at walking pace with smooth
/// starts and stops.
motion::Walk glide(const Placement& start, std::span<const Vec2> path,
                   std::optional<double> final_heading);

}  // namespace docent::plan
