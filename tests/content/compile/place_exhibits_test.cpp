#include "content/compile/place_exhibits.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <fstream>
#include <numbers>

#include "content/compile/compile_floor.h"
#include "runtime/path/floor_map.h"
#include "tests/support/temporary_folder.h"

namespace docent::compile::place_exhibits_test {
namespace {

/// A room of 10 by 8 metres with a case of 1 by 1 in it, and a case let into its south wall.
CompiledFloor room() {
  constexpr const char* plan =
      R"({"type": "Polygon", "coordinates": [[[0, 0], [10, 0], [10, 8], [0, 8], [0, 0]],
          [[6, 4], [6, 5], [7, 5], [7, 4], [6, 4]], [[2, 0], [2, 1], [3, 1], [3, 0], [2, 0]]]})";
  const test::TemporaryFolder folder;
  const std::string file = (folder.path() / "room.geojson").string();
  std::ofstream(file) << plan;
  Report report;
  Progress progress(Progress::Output::Nothing);
  plan_floor_stages(progress);
  const std::vector<double> radii{0, 0.25};
  return compile_floor("room", std::span(&file, 1), import::Coordinates::Metres, radii, report,
                       progress);
}

struct Room {
  CompiledFloor floor = room();
  std::shared_ptr<const path::FloorMap> map = path::make_floor_map(floor.floor);
  PlacingFloor placing{.map = *map, .name = "room", .entrance = Vec2{1, 4}, .body_radius = 0.25};
};

const Room& the_room() {
  static const Room room;
  return room;
}

std::optional<ExhibitPlace> under(Vec2 position) {
  return what_it_stands_on(the_room().map->walls(), the_room().floor.drawn.polygons, {}, position);
}

PlacedExhibit placed(Vec2 position, double degrees) {
  return place_exhibit(the_room().placing, {.position = position,
                                            .heading = degrees * std::numbers::pi / 180,
                                            .place = under(position),
                                            .takes = {},
                                            .view = {}});
}

TEST(PlaceExhibit, TellsFloorWallAndCaseApart) {
  EXPECT_EQ(placed({4, 4}, 0).place, ExhibitPlace::OnFloor);
  EXPECT_EQ(placed({10, 4}, 180).place, ExhibitPlace::OnWall);
  EXPECT_EQ(placed({10.04, 4}, 180).place, ExhibitPlace::OnWall) << "a finger's breadth inside";
  EXPECT_EQ(placed({6.5, 4.5}, 90).place, ExhibitPlace::InCase);
  EXPECT_EQ(placed({2.5, 0.5}, 90).place, ExhibitPlace::InCase) << "a case that touches the wall";
  EXPECT_EQ(placed({11, 4}, 180).problem->kind, PlaceProblem::Kind::Outside);
}

TEST(PlaceExhibit, LetsAVisitorStandStraightInFrontWhereThereIsRoom) {
  const PlacedExhibit exhibit = placed({4, 4}, 180);

  EXPECT_FALSE(exhibit.problem.has_value());
  EXPECT_NEAR(exhibit.view.position.x, 2.6, 1e-9);
  EXPECT_NEAR(exhibit.view.position.y, 4, 1e-9);
  EXPECT_NEAR(exhibit.view.heading, 0, 1e-9);
}

TEST(PlaceExhibit, AlwaysGivesAViewThatIsSeenReachedAndRoomy) {
  EXPECT_TRUE(rc::check("a viewing point keeps its promises", [] {
    const Vec2 position{*rc::gen::inRange(-50, 1050) / 100.0, *rc::gen::inRange(-50, 850) / 100.0};
    const double degrees = *rc::gen::inRange(-360, 361);

    const PlacedExhibit exhibit = placed(position, degrees);

    RC_PRE(!exhibit.problem.has_value());
    const Room& room = the_room();
    const Vec2 view = exhibit.view.position;
    const double distance = glm::distance(view, position);
    RC_ASSERT(path::clearance_at(*room.map, view) >= 0.3 - 1e-9);
    RC_ASSERT(path::is_inside(*room.map, view));
    RC_ASSERT(distance > 0.79);
    RC_ASSERT(distance < 3.0);
    // In front means within 60 degrees of where the object looks.
    const double heading = degrees * std::numbers::pi / 180;
    RC_ASSERT(dot(view - position, {std::cos(heading), std::sin(heading)}) >= distance * 0.499);
  }));
}

TEST(NearestFreePoint, IsTheNearestOfAllPointsOfAFineGrid) {
  EXPECT_TRUE(rc::check("no point of the grid is nearer", [] {
    const Vec2 p{*rc::gen::inRange(-200, 1200) / 100.0, *rc::gen::inRange(-200, 1000) / 100.0};
    const path::FloorMap& map = *the_room().map;

    const auto free = nearest_free_point(map, p, 0.3);

    RC_ASSERT(free.has_value());
    RC_ASSERT(path::is_inside(map, *free));
    RC_ASSERT(path::clearance_at(map, *free) >= 0.3);
    double best = 1e9;
    for (int x = 0; x <= 200; ++x)
      for (int y = 0; y <= 160; ++y)
        if (const Vec2 q{x * 0.05, y * 0.05}; glm::distance(p, q) < best &&
                                              path::is_inside(map, q) &&
                                              path::clearance_at(map, q) >= 0.3)
          best = glm::distance(p, q);
    RC_ASSERT(glm::distance(p, *free) <= best + 0.05);
  }));
}

}  // namespace
}  // namespace docent::compile::place_exhibits_test
