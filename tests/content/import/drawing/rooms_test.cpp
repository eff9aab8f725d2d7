#include "content/import/drawing/rooms.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>
#include <vector>

namespace docent::test::rooms_test {
namespace {

/// Draws plans as an architect does: rooms in rows, walls as two lines, doors as gaps with or
/// without leaf.
struct Draughtsman {
  import::Drawing drawing{.layers = {"0"}};
  double angle = 0;
  Vec2 offset{};

  Vec2 placed(Vec2 p) const {
    return offset + Vec2{p.x * std::cos(angle) - p.y * std::sin(angle),
                         p.x * std::sin(angle) + p.y * std::cos(angle)};
  }
  void line(Vec2 a, Vec2 b) { drawing.segments.push_back({placed(a), placed(b), 0}); }
  void rectangle(Vec2 low, Vec2 high) {
    line(low, {high.x, low.y});
    line({high.x, low.y}, high);
    line(high, {low.x, high.y});
    line({low.x, high.y}, low);
  }
  /// The side of a room with a gap from `from` to `to`, 0 and 0 for none.
  void side(Vec2 a, Vec2 b, double from, double to) {
    const Vec2 along = glm::normalize(b - a);
    if (to <= from) return line(a, b);
    line(a, a + from * along);
    line(a + to * along, b);
  }
  /// A leaf hinged at `hinge`, shut at `shut`, opened by a quarter to the left.
  void leaf(Vec2 hinge, Vec2 shut) {
    const Vec2 open = hinge + left_of(shut - hinge);
    line(hinge, open);
    const auto arc = static_cast<std::uint32_t>(drawing.arcs.size());
    drawing.arcs.push_back({placed(hinge), placed(shut), placed(open), glm::length(shut - hinge),
                            std::numbers::pi / 2, 0});
    Vec2 last = shut;
    for (int i = 1; i <= 15; ++i) {
      const double turn = i * std::numbers::pi / 30;
      const Vec2 arm = shut - hinge;
      const Vec2 next = hinge + std::cos(turn) * arm + std::sin(turn) * left_of(arm);
      drawing.segments.push_back({placed(last), placed(next), 0, true, arc});
      last = next;
    }
  }
};

/// Rooms above a corridor, a door from each, all walls `wall` thick.
struct Row {
  Draughtsman pen;
  std::vector<double> areas;

  Row(const std::vector<double>& widths, double depth, double corridor, double wall, double door,
      bool leaves, double angle) {
    pen.angle = angle;
    pen.offset = {17, -4};
    double x = 0;
    for (const double width : widths) {
      const double from = (width - door) / 2;
      pen.side({x, corridor + wall}, {x + width, corridor + wall}, from, from + door);
      pen.line({x + width, corridor + wall}, {x + width, corridor + wall + depth});
      pen.line({x + width, corridor + wall + depth}, {x, corridor + wall + depth});
      pen.line({x, corridor + wall + depth}, {x, corridor + wall});
      for (const double jamb : {x + from, x + from + door})
        pen.line({jamb, corridor}, {jamb, corridor + wall});
      if (leaves) pen.leaf({x + from, corridor + wall}, {x + from + door, corridor + wall});
      areas.push_back(width * depth);
      x += width + wall;
    }
    const double length = x - wall;
    double last = 0;
    x = 0;
    for (const double width : widths) {  // The corridor's side of the doors.
      const double from = x + (width - door) / 2;
      pen.line({last, corridor}, {from, corridor});
      last = from + door;
      x += width + wall;
    }
    pen.line({last, corridor}, {length, corridor});
    pen.line({length, corridor}, {length, 0});
    pen.line({length, 0}, {0, 0});
    pen.line({0, 0}, {0, corridor});
    areas.push_back(length * corridor);
    pen.rectangle({-wall, -wall}, {length + wall, corridor + wall + depth + wall});
  }
};

import::FoundPlans rooms_of(const import::Drawing& drawing) {
  return import::find_rooms(
      drawing, std::vector<import::LayerKind>(drawing.layers.size(), import::LayerKind::Unknown));
}

std::size_t found_within(const import::FoundPlan& plan, const std::vector<double>& areas,
                         double part) {
  std::size_t found = 0;
  for (const double area : areas)
    found += std::ranges::any_of(plan.rooms, [&](const import::FoundRoom& room) {
      return std::abs(room.area - area) < part * area;
    });
  return found;
}

/// The yardstick, nine rooms of ten; a thick wall beside a narrow room still costs one now
/// and then.
TEST(Rooms, OfDoubleWallsAreFoundWithinFivePerCentOfTheirAreaNineTimesOfTen) {
  std::mt19937 random(7);
  const auto metres = [&random](int low, int high) {
    return std::uniform_int_distribution(low, high - 1)(random) / 100.0;
  };
  std::size_t known = 0, within = 0, doors = 0, found_doors = 0;
  for (int plan = 0; plan < 100; ++plan) {
    std::vector<double> widths(std::uniform_int_distribution<std::size_t>(2, 6)(random));
    for (double& width : widths) width = metres(250, 900);
    const bool leaves = plan % 2 == 0;
    const Row row(widths, metres(250, 800), metres(160, 400), metres(8, 60), metres(70, 140),
                  leaves, metres(0, 628));

    const import::FoundPlans found = rooms_of(row.pen.drawing);

    known += row.areas.size();
    doors += widths.size();
    if (found.plans.empty()) continue;
    within += found_within(found.plans[0], row.areas, 0.05);
    for (const import::FoundDoor& door : found.plans[0].doors)
      if (door.swing == leaves && door.rooms == 2U) ++found_doors;
  }
  std::printf("%zu of %zu rooms, %zu of %zu doors\n", within, known, found_doors, doors);
  EXPECT_GE(10 * within, 9 * known);
  EXPECT_GE(10 * found_doors, 9 * doors);
}

TEST(Rooms, LeaveOutASectionBesideThePlan) {
  Row row({4, 5, 6}, 5, 2, 0.2, 0.9, true, 0);
  row.pen.rectangle({40, 0}, {60, 4});
  row.pen.rectangle({40, 4.3}, {60, 8});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.plans[0].rooms.size(), 4U);
}

TEST(Rooms, DropStrokesTwelveThousandKilometresAway) {
  Row row({4, 5, 6}, 5, 2, 0.2, 0.9, true, 0);
  row.pen.line({12e6, 9e6}, {12e6 + 1, 9e6});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.plans[0].rooms.size(), 4U);
  EXPECT_EQ(found.culled.at("strokes far away from the plan"), 1U);
}

TEST(Rooms, KeepColumnsAsObstaclesAndTheirHallWhole) {
  Row row({20, 5}, 12, 2, 0.2, 0.9, true, 0);
  for (const double x : {4.0, 8.0, 12.0, 16.0}) row.pen.rectangle({x, 6}, {x + 0.4, 6.4});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.plans[0].columns.size(), 4U);
  EXPECT_EQ(found_within(found.plans[0], {240 - 0.64}, 0.001), 1U);
}

TEST(Rooms, TakeTheirNamesFromTheTextsInThem) {
  Row row({4, 5}, 5, 2, 0.2, 0.9, true, 0);
  row.pen.drawing.texts.push_back({"Cloakroom", row.pen.placed({2, 5}), 0.3, 0});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(std::ranges::count(found.plans[0].rooms, "Cloakroom", &import::FoundRoom::name), 1);
}

/// Two rooms with one line between them; the door in it is drawn ajar, by hand: the leaf's tip is
/// beside the arc, and the arc is about a centre that is not the hinge.
TEST(Rooms, AreJoinedByADoorDrawnAjar) {
  Draughtsman pen;
  pen.rectangle({0, 0}, {8, 5});
  pen.line({4, 0}, {4, 5});
  const Vec2 hinge{4, 3.3}, shut{4, 2.59}, tip{3.884, 2.579};
  for (const Vec2 jamb : {hinge, shut}) pen.line(jamb - Vec2{0.05, 0}, jamb + Vec2{0.05, 0});
  pen.line(hinge, tip);
  const auto arc = static_cast<std::uint32_t>(pen.drawing.arcs.size());
  const Vec2 begin{3.875, 2.613};
  pen.drawing.arcs.push_back({{3.996, 2.99}, begin, shut, 0.396, 0.32, 0});
  pen.drawing.segments.push_back({begin, shut, 0, true, arc});

  const import::FoundPlans found = rooms_of(pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.plans[0].rooms.size(), 2U);
  ASSERT_EQ(found.plans[0].doors.size(), 1U);
  EXPECT_TRUE(found.plans[0].doors[0].swing);
}

/// A bay's arc leads from wall to wall, and no leaf to its end.
TEST(Rooms, KeepTheArcOfABay) {
  Draughtsman pen;
  for (const auto& [a, b] : {std::pair{Vec2{0, 0}, Vec2{8, 0}},
                             {{8, 0}, {8, 5}},
                             {{0, 5}, {0, 0}},
                             {{8, 5}, {5, 5}},
                             {{3, 5}, {0, 5}}})
    pen.line(a, b);
  const auto arc = static_cast<std::uint32_t>(pen.drawing.arcs.size());
  pen.drawing.arcs.push_back({{4, 5}, {5, 5}, {3, 5}, 1, std::numbers::pi * 0.8, 0});
  Vec2 last{5, 5};
  for (int i = 1; i <= 20; ++i) {
    const double turn = i * std::numbers::pi / 20;
    const Vec2 next = Vec2{4, 5} + Vec2{std::cos(turn), std::sin(turn)};
    pen.drawing.segments.push_back({last, next, 0, true, arc});
    last = next;
  }

  const import::FoundPlans found = rooms_of(pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  ASSERT_EQ(found.plans[0].rooms.size(), 1U);
  EXPECT_NEAR(found.plans[0].rooms[0].area, 40 + std::numbers::pi / 2, 0.02);
}

/// Nine treads 0.28 m deep beside a wall: one flight, and the hall is as large as without it.
TEST(Rooms, HaveStairsWhereTreadsAre) {
  Row row({8, 5}, 6, 2, 0.2, 0.9, true, 0.3);
  for (int i = 0; i < 9; ++i) row.pen.line({1 + 0.28 * i, 4}, {1 + 0.28 * i, 5.5});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  ASSERT_EQ(found.plans[0].stairs.size(), 1U);
  EXPECT_EQ(found.plans[0].stairs[0].kind, "stairs");
  EXPECT_NEAR(glm::distance(found.plans[0].stairs[0].middle, row.pen.placed({2.12, 4.75})), 0,
              0.01);
  EXPECT_EQ(found_within(found.plans[0], {48}, 0.001), 1U);
}

TEST(Rooms, HaveNoStairsWhereBoardsAre) {
  Row row({8, 5}, 6, 2, 0.2, 0.9, true, 0);
  for (int i = 0; i < 60; ++i)  // Boards of a floor: too shallow for treads.
    row.pen.line({0.1 + 0.12 * i, 3}, {0.1 + 0.12 * i, 5});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_TRUE(found.plans[0].stairs.empty());
}

TEST(Rooms, AreStairsWhereTheirNameSaysSo) {
  Row row({4, 5}, 5, 2, 0.2, 0.9, true, 0);
  row.pen.drawing.texts.push_back({"ESCALIER C", row.pen.placed({2, 5}), 0.3, 0});

  const import::FoundPlans found = rooms_of(row.pen.drawing);

  ASSERT_EQ(found.plans.size(), 1U);
  ASSERT_EQ(found.plans[0].stairs.size(), 1U);
  EXPECT_EQ(found.plans[0].stairs[0].name, "ESCALIER C");
}

TEST(Rooms, AreClosedOutlinesWhereALayerHasThem) {
  import::Drawing drawing{.layers = {"ROOM OUTLINES"}};
  for (int i = 0; i < 3; ++i) {
    const double x = 5.0 * i;
    drawing.rings.push_back({{{x, 0}, {x + 4, 0}, {x + 4, 4}, {x, 4}}, 0, 7});
  }

  const import::FoundPlans found = import::find_rooms(drawing, {import::LayerKind::Room});

  EXPECT_TRUE(found.outlines_taken);
  ASSERT_EQ(found.plans.size(), 1U);
  EXPECT_EQ(found.plans[0].rooms.size(), 3U);
}

TEST(Rooms, AreRefusedWithASentenceWhereTheWallsAreTensOfKilometresApart) {
  Draughtsman pen;
  for (int i = 0; i < 18; ++i) pen.rectangle({4000.0 * i, 0}, {4000.0 * i + 900, 900});

  EXPECT_THAT(rooms_of(pen.drawing).refused, testing::HasSubstr("69 km apart"));
}

TEST(Rooms, AreRefusedWithASentenceWhereThereAreTooManyStrokes) {
  Draughtsman pen;
  for (int i = 0; i < 130'000; ++i)
    pen.line({0.1 * (i % 400), 0.1 * (i / 400)}, {0.1 * (i % 400) + 0.05, 0.1 * (i / 400)});

  EXPECT_THAT(rooms_of(pen.drawing).refused, testing::HasSubstr("strokes could be walls"));
}

}  // namespace
}  // namespace docent::test::rooms_test
