// A guide that nobody else is near: the walls are there all the same.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/crowd.h"
#include "runtime/path/route.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"

namespace docent::guide::lone_guide_test {
namespace {

/// Places before and behind a door, `metres` from it, looking through it.
std::array<Placement, 2> both_sides(const Door& door, double metres) {
  const Vec2 along = (door.b - door.a) / glm::distance(door.a, door.b);
  const Vec2 through{-along.y, along.x}, middle = (door.a + door.b) / 2.0;
  const double heading = std::atan2(through.y, through.x);
  return {{{middle - metres * through, heading}, {middle + metres * through, heading}}};
}

TEST(AGuideAlone, CalledBackAtAnyMomentInADoorwayComesNoNearerToItsJambs) {
  const Museum museum = sqlite::load_museum(test::sample_database()).value();
  const std::vector<Door>& doors = museum.floors[museum.kiosk_floor].plan.doors;
  ASSERT_FALSE(doors.empty());
  constexpr double seconds_a_door = test::is_sanitized ? 30 : 240;
  double least = 1e9, walked = 0;
  for (const Door& door : doors) {
    plan::Planner planner(museum, {}, 1);
    const auto map = planner.maps()[museum.kiosk_floor];
    const auto sides = both_sides(door, 1.5);
    Crowd crowd(museum, planner);
    crowd.add(museum.kiosk_floor, sides[0], 100, 1);
    std::mt19937 random(7);
    double next_call = 0;
    for (int side = 1; crowd.clock() < seconds_a_door;) {
      if (crowd.clock() >= next_call) {
        crowd.send(0, museum.kiosk_floor, sides[static_cast<std::size_t>(side)],
                   RouteKind::Shortest);
        side = 1 - side;
        next_call = crowd.clock() + std::uniform_real_distribution(1.5, 6.0)(random);
      }
      planner.wait();
      const Vec2 before = crowd[0].avatar.body.position;
      crowd.step(1.0 / 60);
      const Vec2 place = crowd[0].avatar.body.position;
      walked += glm::distance(before, place);
      least = std::min(least, path::clearance_at(*map, place));
    }
  }
  EXPECT_GE(least, museum.body_radius - 0.01);
  EXPECT_GT(walked, static_cast<double>(doors.size()) * seconds_a_door * 0.1);  // and it walks
}

}  // namespace
}  // namespace docent::guide::lone_guide_test
