#include "runtime/guide/turn_table.h"

#include <gtest/gtest.h>

#include <array>
#include <numbers>

namespace docent::guide::turn_table_test {
namespace {

constexpr scene::Rect free{0, 0, 0.5F, 1};
constexpr float frame = 1.0F / 60;

input::Finger finger(float from, float at, std::uint32_t id = 3) {
  input::Finger finger;
  finger.start = {.id = id, .x = from, .y = 0.5F};
  finger.at = {.id = id, .x = at, .y = 0.5F};
  return finger;
}

TEST(TurnTable, TurnsAllRoundForAFingerThatCrossesIt) {
  TurnTable table;
  table.put(4);
  for (int i = 1; i <= 25; ++i) {
    const std::array fingers{finger(0.1F, 0.1F + 0.01F * static_cast<float>(i))};
    table.step(fingers, free, 0, frame);
  }

  EXPECT_NEAR(std::abs(table.angle()), std::numbers::pi, 0.01);
}

TEST(TurnTable, GoesOnForAWhileWhenItIsLetGo) {
  TurnTable table;
  table.put(4);
  for (int i = 0; i <= 10; ++i) {
    const std::array fingers{finger(0.1F, 0.1F + 0.005F * static_cast<float>(i))};
    table.step(fingers, free, 0, frame);
  }
  const float let_go = table.angle();
  for (int i = 0; i < 30; ++i) table.step({}, free, frame, frame);
  const float later = table.angle();
  for (int i = 0; i < 600; ++i) table.step({}, free, frame, frame);
  const float at_rest = table.angle();
  for (int i = 0; i < 60; ++i) table.step({}, free, frame, frame);

  EXPECT_GT(later, let_go + 0.3F);
  EXPECT_EQ(table.angle(), at_rest) << "and does not sway any more";
}

TEST(TurnTable, IsNotTurnedFromThePanel) {
  TurnTable table;
  table.put(4);
  for (int i = 0; i < 10; ++i) {
    const std::array fingers{finger(0.7F, 0.7F - 0.02F * static_cast<float>(i))};
    table.step(fingers, free, 0, frame);
  }

  EXPECT_EQ(table.angle(), 0);
}

TEST(TurnTable, TurnsByATwelfthForAKey) {
  TurnTable table;
  table.put(4);
  table.turn(false);
  for (int i = 0; i < 120; ++i) table.step({}, free, frame, frame);

  EXPECT_NEAR(table.angle(), std::numbers::pi / 6, 0.001);
  table.turn(true);
  for (int i = 0; i < 120; ++i) table.step({}, free, frame, frame);
  EXPECT_NEAR(table.angle(), 0, 0.001);
}

TEST(TurnTable, SwaysUntilItIsTouchedAndStandsStillWithReducedMotion) {
  TurnTable swaying, still;
  swaying.put(4);
  still.put(4);
  for (int i = 0; i < 120; ++i) {
    swaying.step({}, free, frame, frame);
    still.step({}, free, 0, frame);
  }

  EXPECT_GT(std::abs(swaying.angle()), 0.1F);
  EXPECT_EQ(still.angle(), 0);
}

TEST(TurnTable, OfAnotherExhibitStandsAsItWasPlaced) {
  TurnTable table;
  table.put(4);
  table.turn(true);
  for (int i = 0; i < 60; ++i) table.step({}, free, frame, frame);
  table.put(5);

  EXPECT_EQ(table.angle(), 0);
  table.put({});
  table.turn(true);
  table.step({}, free, frame, frame);
  EXPECT_EQ(table.angle(), 0) << "there is nothing on it";
}

TEST(DrawObjects, ShowsThoseOfTheFloorAndSaysWhichIsLookedAt) {
  Museum museum;
  museum.floors.resize(2);
  museum.floors[1].plan.height = 4;
  museum.objects.resize(2);
  museum.exhibits.resize(3);
  museum.exhibits[0].object = 1;
  museum.exhibits[0].floor = 1;
  museum.exhibits[0].stand = {.position = {2, 3}, .base = 0.5, .scale = 0.25};
  museum.exhibits[1].object = 0;
  museum.exhibits[2].floor = 1;
  TurnTable table;
  table.put(0);
  table.turn(false);
  for (int i = 0; i < 120; ++i) table.step({}, free, 0, frame);
  scene::DrawList list;
  list.objects.reserve(3);
  draw_objects(museum, 1, table, 0, list);

  ASSERT_EQ(list.objects.size(), 1U);
  EXPECT_EQ(list.objects[0].object, 1U);
  EXPECT_EQ(list.objects[0].foot, to_world({2, 3}, 4.5));
  EXPECT_EQ(list.objects[0].scale, 0.25F);
  EXPECT_EQ(list.objects[0].heading, table.angle());
  EXPECT_EQ(list.near_object, 1U);
  draw_objects(museum, 0, table, 0, list);
  EXPECT_FALSE(list.near_object.has_value());
}

}  // namespace
}  // namespace docent::guide::turn_table_test
