#include "content/scenery/flight.h"

#include <gmock/gmock.h>
#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "content/scenery/scenery.h"
#include "runtime/model/geometry/polygon.h"
#include "tests/support/halls.h"

namespace docent::scenery::flight_test {
namespace {

using test::HallMaker;

/// A hall with a hole for a flight that one enters from the west.
FloorPlan hall_with_stairwell() {
  return HallMaker().room({0, 0}, {12, 6}).block({3, 2}, {9, 4}).plan;
}

Passage passage(double rise, ConnectionKind kind = ConnectionKind::Stairs) {
  return {.kind = kind, .here = {{2.4, 3}, 0}, .there = {9.6, 3}, .rise = rise};
}

Scenery with(const FloorPlan& plan, std::vector<Passage> passages) {
  return make_scenery(plan, {}, {}, {}, {.passages = std::move(passages), .texel = 0.1});
}

std::vector<Vec3> corners_of(const Scenery& scenery, Surface surface) {
  std::vector<Vec3> corners;
  for (const SceneryPart& part : scenery.parts)
    for (std::uint32_t i = 0; part.surface == surface && i < part.index_count; ++i)
      corners.push_back(scenery.vertices[scenery.indices[part.first_index + i]].position);
  return corners;
}

/// Square metres of a surface, seen from above.
double area_of(const Scenery& scenery, Surface surface) {
  const std::vector<Vec3> corner = corners_of(scenery, surface);
  double area = 0;
  for (std::size_t i = 0; i + 2 < corner.size(); i += 3)
    area += cross(to_floor(corner[i + 1]) - to_floor(corner[i]),
                  to_floor(corner[i + 2]) - to_floor(corner[i])) /
            2;
  return area;
}

/// The heights of treads, from the floor on.
std::vector<double> heights_of_treads(const Scenery& scenery) {
  std::vector<double> heights;
  for (const Vec3& corner : corners_of(scenery, Surface::CaseBody)) heights.push_back(corner.y);
  std::ranges::sort(heights, {}, [](double height) { return std::abs(height); });
  const auto same =
      std::ranges::unique(heights, [](double a, double b) { return std::abs(a - b) < 1e-4; });
  heights.erase(same.begin(), same.end());
  return heights;
}

TEST(Flight, IsWhereThePlanHasAHoleBetweenItsStops) {
  const auto flight = flight_of(hall_with_stairwell(), passage(4));

  ASSERT_TRUE(flight);
  EXPECT_EQ(flight->ring, 1U);
}

TEST(Flight, IsNotBuiltWhereOneCanWalk) {
  const FloorPlan hall = HallMaker().room({0, 0}, {12, 6}).plan;

  EXPECT_FALSE(flight_of(hall, passage(4)));
  EXPECT_TRUE(corners_of(with(hall, {passage(4)}), Surface::CaseBody).empty());
}

TEST(Flight, ThatLeadsUpIsCutAtTheHeightOfTheWalls) {
  const Scenery scenery = with(hall_with_stairwell(), {passage(4)});

  for (const SceneryVertex& vertex : scenery.vertices)
    EXPECT_LE(vertex.position.y, cut_height + 0.01);
}

TEST(Flight, RisesByStepsOfAHandsBreadthAtMost) {
  EXPECT_TRUE(rc::check("no step is higher than 17 cm", [] {
    const double rise = *rc::gen::inRange(50, 800) / 100.0;
    const bool down = *rc::gen::arbitrary<bool>();

    std::vector<double> heights =
        heights_of_treads(with(hall_with_stairwell(), {passage(down ? -rise : rise)}));

    RC_ASSERT(!heights.empty());
    // Going down, the uppermost tread is level with this floor, and from the lowest one goes down
    // to the other.
    if (down) heights.push_back(-rise);
    double before = down ? 1e-5 : 0;
    for (const double height : heights) {
      RC_ASSERT(std::abs(height - before) <= 0.17 + 1e-4);
      RC_ASSERT((height < before) == down);
      before = height;
    }
    RC_ASSERT(std::abs(before - (down ? -rise : std::min(rise, cut_height))) < 1e-4);
  }));
}

TEST(Flight, ThatLeadsDownOpensTheFloorAndTheTable) {
  const FloorPlan plan = hall_with_stairwell();
  const Scenery closed = with(plan, {});
  const Scenery open = with(plan, {passage(-4)});

  // Without a flight the hole is a block of building, on which no floor lies either.
  EXPECT_NEAR(area_of(open, Surface::Floor), 12 * 6 - 6 * 2, 1e-3);
  EXPECT_NEAR(area_of(closed, Surface::Ground) - area_of(open, Surface::Ground), 6 * 2, 1e-2);
}

TEST(Flight, LightReachesTheUpperStepsOfAnOpening) {
  const Scenery scenery = with(hall_with_stairwell(), {passage(-4)});

  std::uint8_t upper = 0;
  std::uint8_t lower = 0;
  for (const SceneryVertex& vertex : scenery.vertices) {
    if (vertex.normal.y < 0.99F) continue;
    if (vertex.position.y < 0 && vertex.position.y > -0.5) upper = std::max(upper, vertex.sky);
    if (vertex.position.y < -3.5) lower = std::max(lower, vertex.sky);
  }
  EXPECT_GT(upper, lower);
  EXPECT_GT(upper, 150);
}

TEST(Flight, OfAnEscalatorHasBalustrades) {
  const Scenery stairs = with(hall_with_stairwell(), {passage(4)});
  const Scenery escalator = with(hall_with_stairwell(), {passage(4, ConnectionKind::Escalator)});

  EXPECT_TRUE(corners_of(stairs, Surface::Frame).empty());
  EXPECT_FALSE(corners_of(escalator, Surface::Frame).empty());
}

TEST(Flight, HasEveryFaceCounterClockwiseSeenFromItsNormal) {
  for (const ConnectionKind kind :
       {ConnectionKind::Stairs, ConnectionKind::Escalator, ConnectionKind::Ramp})
    for (const double rise : {4.0, -4.0}) {
      const Scenery scenery = with(hall_with_stairwell(), {passage(rise, kind)});
      for (std::size_t i = 0; i < scenery.indices.size(); i += 3) {
        const auto vertex = [&](std::size_t k) { return scenery.vertices[scenery.indices[i + k]]; };
        const Vec3 facing = glm::cross(vertex(1).position - vertex(0).position,
                                       vertex(2).position - vertex(0).position);
        if (glm::dot(facing, facing) < 1e-12F) continue;
        EXPECT_GT(glm::dot(facing, vertex(0).normal), 0) << static_cast<int>(kind) << ' ' << rise;
      }
    }
}

}  // namespace
}  // namespace docent::scenery::flight_test
