#pragma once

#include <optional>
#include <span>
#include <vector>

#include "runtime/path/floor_map.h"
#include "runtime/plan/plan.h"

namespace docent::plan {

/// The parts that plans are made of, for a guide alone (make_plan.cpp) and among others
/// (traffic.cpp).

/// The place of a walk's frame.
Placement last_place(const motion::Walk& walk, std::uint32_t frame,
                     const Placement& otherwise) noexcept;

/// What is left of a plan's way at one of its frames.
std::vector<Vec2> way_ahead(const Plan& plan, std::uint32_t frame);

/// The way from where the guide is, with room for walking. Where that is too much, or a body in
/// mid-step stands nearer to a wall than its circle may, a thinner one goes.
path::Way find_way(const Museum& museum, const path::FloorMap& map, const WalkOrder& order,
                   Vec2 from);

/// Notes the way in the plan, simplified to what the ribbon and the camera need.
void keep_way(std::span<const Vec2> points, Plan& plan);

/// The walk along some points, going on from what the order goes on from.
motion::Walk walk_along(const motion::WalkGraph* walking, const WalkOrder& order,
                        const Placement& from, std::span<const Vec2> points,
                        std::optional<double> final_heading);

/// Where a walk that ends on its way is best taken over: soon after its last transition before the
/// one that leads to the stand, when every other that the clip offers is still ahead. None where
/// that is too near to the beginning.
std::optional<std::uint32_t> find_handover_frame(const MotionGraph& motion,
                                                 const motion::Walk& walk);

}  // namespace docent::plan
