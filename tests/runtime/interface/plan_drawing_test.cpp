#include "runtime/interface/plan_drawing.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/gtc/constants.hpp>

namespace docent::interface::plan_drawing_test {
namespace {

/// A hall of 20 m from west to east and 10 m from south to north.
FloorPlan hall() {
  FloorPlan plan;
  plan.vertex = {{0, 0}, {20, 0}, {20, 10}, {0, 10}};
  plan.ring = {{0, 4}};
  plan.next = {1, 2, 3, 0};
  return plan;
}
constexpr DrawingShape shape{
    .width = 240, .height = 160, .plan_least = {20, 40}, .plan_most = {220, 140}};

std::array<int, 4> pixel(const Pixels& pixels, Vec2 at) {
  const auto x = static_cast<std::size_t>(at.x), y = static_cast<std::size_t>(at.y);
  std::array<int, 4> rgba{};
  for (std::size_t c = 0; c < 4; ++c)
    rgba[c] = std::to_integer<int>(pixels.rgba[4 * (y * pixels.width + x) + c]);
  return rgba;
}

TEST(PlanDrawing, TurnsWhatIsAheadOfTheVisitorUp) {
  const FloorPlan plan = hall();
  for (const double heading : {0.0, 1.0, 2.5, -1.5}) {
    const PlanFrame frame = frame_of(plan, heading, shape);
    const Vec2 here{10, 5}, ahead = here + 2.0 * Vec2{std::cos(heading), std::sin(heading)};
    const Vec2 up = frame.pixel(ahead) - frame.pixel(here);
    EXPECT_NEAR(up.x, 0, 1e-9);
    EXPECT_NEAR(up.y, -2 * frame.scale, 1e-9);
    EXPECT_NEAR(frame.pixel({10, 5}).x, 120, 1e-9) << "in the middle";
    EXPECT_NEAR(frame.pixel({10, 5}).y, 90, 1e-9);
    for (const Vec2 corner : plan.vertex) {
      const Vec2 at = frame.pixel(corner);
      EXPECT_TRUE(at.x > 19.99 && at.x < 220.01 && at.y > 39.99 && at.y < 140.01);
    }
  }
  EXPECT_NEAR(aspect_of(plan, glm::half_pi<double>()), 2, 1e-9);
  EXPECT_NEAR(aspect_of(plan, 0), 0.5, 1e-9);
}

TEST(PlanDrawing, ShowsTheFloorTheWayAndWhereOneStands) {
  const FloorPlan plan = hall();
  const PlanFrame frame = frame_of(plan, glm::half_pi<double>(), shape);
  const std::array<Vec2, 3> way{{{10, 2}, {10, 8}, {18, 8}}};
  const Pixels pixels = draw_plan({.plan = plan,
                                   .frame = frame,
                                   .shape = shape,
                                   .way = way,
                                   .way_colour = 0xD2452D,
                                   .here = Vec2{10, 2},
                                   .compass = {220, 20},
                                   .unit = 4});

  using Rgba = std::array<int, 4>;
  EXPECT_EQ(pixel(pixels, {2, 150})[3], 0) << "nothing beside the plan";
  EXPECT_EQ(pixel(pixels, frame.pixel({3, 3})), (Rgba{0xE0, 0xD8, 0xC9, 255}));
  EXPECT_EQ(pixel(pixels, frame.pixel({14, 8})), (Rgba{0xD2, 0x45, 0x2D, 255}));
  EXPECT_EQ(pixel(pixels, frame.pixel({10, 2})), (Rgba{0x1E, 0x1C, 0x1A, 255}));
  EXPECT_EQ(pixel(pixels, {220, 20 - 2.7 * 4}), (Rgba{0x1E, 0x1C, 0x1A, 255})) << "north is up";
}

TEST(PlanDrawing, OfAnotherFloorHasNobodyStandingThere) {
  const FloorPlan plan = hall();
  const PlanFrame frame = frame_of(plan, glm::half_pi<double>(), shape);
  const Pixels pixels = draw_plan({.plan = plan, .frame = frame, .shape = shape, .unit = 4});

  using Rgba = std::array<int, 4>;
  EXPECT_EQ(pixel(pixels, frame.pixel({3, 3})), (Rgba{0xE0, 0xD8, 0xC9, 255}));
  EXPECT_EQ(pixel(pixels, frame.pixel({10, 2})), (Rgba{0xE0, 0xD8, 0xC9, 255}));
}

TEST(PlanDrawing, IsDefinedForAFloorThatIsNone) {
  const FloorPlan plan;
  const PlanFrame frame = frame_of(plan, 0, shape);
  EXPECT_EQ(draw_plan({.plan = plan, .frame = frame, .shape = shape}).rgba.size(), 4U * 240 * 160);
}

}  // namespace
}  // namespace docent::interface::plan_drawing_test
