#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/path/floor_map.h"
#include "runtime/plan/plan.h"

namespace docent::plan {

/// The parts that plans are made of. Frame: floor.

inline constexpr double stretch_length = 8;  ///< Metres of a long way walked before the next.
inline constexpr double least_rest = 4;      ///< Metres that are worth a stretch of their own.

/// The placement of the body in a walk's frame; `otherwise` where the walk is empty.
Placement last_place(const motion::Walk& walk, std::uint32_t frame,
                     const Placement& otherwise) noexcept;

/// Where the body of an order is when the new plan takes over, and when that is (crowd's clock).
Placement takes_over_at(const WalkOrder& order) noexcept;
inline double seconds_of(const WalkOrder& order) noexcept {
  return order.seconds.value_or(0);
}

/// What is left of a plan's way at one of its frames.
std::vector<Vec2> way_ahead(const Plan& plan, std::uint32_t frame);

/// The way of a body along its floor, with Museum::walking_room to spare. A body in mid-step, or
/// one that is to stand beside a wall, may have less room there: the way then leads from and to
/// where there is room. Where there is none, it is that of a thinner body.
path::Way find_way(const Museum& museum, const path::FloorMap& map, RouteKind kind, Vec2 from,
                   Vec2 to);

/// Notes the way in the plan, simplified to what the ribbon and the camera need.
void keep_way(std::span<const Vec2> points, Plan& plan);

/// The walk along some points. It goes on from the order's previous plan, if there is one.
/// `careful`: where it slows down.
motion::Walk walk_along(const motion::WalkGraph* walking, const WalkOrder& order,
                        const Placement& from, std::span<const Vec2> points,
                        std::optional<double> final_heading,
                        std::span<const motion::CarefulPlace> careful = {});

/// The frame at which the next stretch best takes over from a walk: soon after the last transition
/// before the one that leads to the stand, while all others that the clip offers are still ahead.
/// None where that is too near to the walk's beginning.
std::optional<std::uint32_t> find_handover_frame(const MotionGraph& motion,
                                                 const motion::Walk& walk);

}  // namespace docent::plan
