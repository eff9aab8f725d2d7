#pragma once

#include <cstdint>
#include <optional>
#include <span>

#include "runtime/model/geometry/floor_plan.h"
#include "runtime/model/pixels.h"

namespace docent::interface {

/// How a floor lies on a small drawing: turned so that what is ahead of the visitor is up.
struct PlanFrame {
  Vec2 origin{};                  ///< Floor frame: the drawing's upper left corner.
  Vec2 right{1, 0}, down{0, -1};  ///< Floor frame, unit.
  double scale = 1;               ///< Pixels a metre.

  Vec2 pixel(Vec2 at) const noexcept {
    return scale * Vec2{dot(at - origin, right), dot(at - origin, down)};
  }
};

/// Where a drawing has its pixels: the whole of it, and the part that is the plan's.
struct DrawingShape {
  std::uint32_t width = 0, height = 0;
  Vec2 plan_least{}, plan_most{};  ///< Pixels.
};

/// The frame in which a floor fills the plan's part, in its middle.
PlanFrame frame_of(const FloorPlan& plan, double heading, const DrawingShape& shape) noexcept;

/// How wide a floor is for its height, seen with that heading up.
double aspect_of(const FloorPlan& plan, double heading) noexcept;

/// 0xRRGGBB.
struct PlanColours {
  std::uint32_t floor = 0xE0D8C9, wall = 0x6E675E, ink = 0x1E1C1A, paper = 0xF5F1E8;
};
inline constexpr PlanColours plan_at_night{
    .floor = 0x37332E, .wall = 0x9C9385, .ink = 0xF0E8DA, .paper = 0x1C1A18};

/// What is drawn on the plan.
struct PlanDrawing {
  const FloorPlan& plan;
  PlanFrame frame;
  DrawingShape shape;
  std::span<const Vec2> way{};   ///< Floor frame.
  std::uint32_t way_colour = 0;  ///< 0xRRGGBB.
  bool is_cased = false;         ///< With a dark edge, where its colour is pale.
  PlanColours colours{};
  std::optional<Vec2> here{};  ///< Floor frame: where the visitor stands, looking up.
  Vec2 compass{};              ///< Pixels: the middle of the north arrow's ring.
  double unit = 8;             ///< Pixels: lines and marks are sized by it.
};

/// Draws the floor, its walls, the way with a ring at its end, where the visitor stands and looks,
/// and a north arrow. Transparent where nothing is. Runs on the worker.
Pixels draw_plan(const PlanDrawing& drawing);

}  // namespace docent::interface
