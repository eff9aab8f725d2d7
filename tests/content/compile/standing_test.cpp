#include "content/compile/standing.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

#include "platform/sqlite/content_reader.h"
#include "runtime/path/route.h"
#include "tests/support/museum_folder.h"

namespace docent::compile::standing_test {
namespace {

using test::MuseumFolder;
using testing::HasSubstr;
using testing::SizeIs;

/// A free exhibit.
Standing statue(Vec2 at, double size) {
  return {.name = "exhibit 'statue'",
          .footprint = {.centre = at, .heading = 0, .size = {size, size}},
          .place = ExhibitPlace::OnFloor};
}

TEST(Standing, TakesFloorWhereItStandsFreeAndHasASize) {
  Standing thing = statue({4, 4}, 0.6);
  EXPECT_TRUE(takes_floor(thing));
  for (const auto place : {std::optional(ExhibitPlace::OnWall), std::optional(ExhibitPlace::InCase),
                           std::optional<ExhibitPlace>()}) {
    thing.place = place;
    EXPECT_FALSE(takes_floor(thing));
  }
  EXPECT_FALSE(takes_floor(statue({4, 4}, 0)));
  thing.kind = Standing::Kind::Case;
  EXPECT_TRUE(takes_floor(thing));
}

TEST(Standing, OverlapsAreToldOnceForEachThing) {
  const std::vector<Standing> things{statue({1, 1}, 1), statue({1.5, 1}, 1), statue({1.8, 1}, 1),
                                     statue({5, 1}, 1), statue({6.003, 1}, 1)};

  const std::vector<Overlap> overlaps = overlaps_of(things);

  ASSERT_THAT(overlaps, SizeIs(2));
  EXPECT_EQ(overlaps[0].second, &things[1]);
  EXPECT_NEAR(overlaps[0].depth, 0.5, 1e-9);
  EXPECT_EQ(overlaps[1].first, &things[0]);
}

Museum compiled(const MuseumFolder& folder) {
  const test::ProgramRun run = folder.compile();
  EXPECT_EQ(run.exit_code, 0) << run.err;
  return sqlite::load_museum(folder.database()).value_or(Museum{});
}

void add_exhibit(const MuseumFolder& folder, const std::string& rest) {
  folder.write("exhibits/statue.toml",
               "[[exhibit]]\nid = \"statue\"\nimage = \"images/disc.svg\"\ntitle.en = \"S\"\n"
               "title.ar = \"S\"\n" +
                   rest);
}

/// The same floor with what an exhibit takes drawn into its plan.
void draw_hole(const MuseumFolder& folder, const std::string& ring) {
  folder.replace("ground.geojson", "[6, 4]]],", "[6, 4]], [" + ring + "]],");
}

TEST(AFreeExhibit, IsWalkedRoundExactlyAsIfItWereDrawn) {
  const MuseumFolder free, with_hole;
  add_exhibit(free, "position = [4, 4]\nfacing = 0\nsize = [1.2, 0.8]\n");
  draw_hole(with_hole, "[3.6, 3.4], [3.6, 4.6], [4.4, 4.6], [4.4, 3.4], [3.6, 3.4]");
  const Museum one = compiled(free), other = compiled(with_hole);
  const auto map = path::make_floor_map(one.floors.at(0)),
             expected = path::make_floor_map(other.floors.at(0));

  std::mt19937 random(7);
  std::uniform_real_distribution<double> x(0.3, 9.7), y(0.3, 7.7);
  for (int i = 0; i < 300; ++i) {
    const Vec2 from{x(random), y(random)}, to{x(random), y(random)};
    for (const RouteKind kind : {RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset}) {
      const path::RouteQuery query{.kind = kind, .from = from, .to = to, .radius = 0.25};
      const path::Way way = path::route(*map, query), drawn = path::route(*expected, query);
      ASSERT_EQ(way.status, drawn.status);
      EXPECT_NEAR(way.length, drawn.length, 1e-6);
    }
    EXPECT_NEAR(path::clearance_at(*map, from), path::clearance_at(*expected, from), 1e-9);
    EXPECT_EQ(path::can_see(*map, from, to), path::can_see(*expected, from, to));
  }
}

TEST(AFreeExhibit, TakesSixtyCentimetresWhereNothingIsSaidAndIsSeenFromItsEdge) {
  const MuseumFolder folder;
  add_exhibit(folder, "position = [3, 6]\nfacing = 0\n");
  const Museum museum = compiled(folder);
  const auto map = path::make_floor_map(museum.floors.at(0));

  EXPECT_FALSE(path::is_inside(*map, {3, 6}));
  EXPECT_NEAR(path::clearance_at(*map, {3, 6}), 0.3, 1e-9);
  const Exhibit& statue = museum.exhibits.at(2);
  EXPECT_EQ(statue.place, ExhibitPlace::OnFloor);
  EXPECT_NEAR(statue.viewing_point.position.x, 4.4, 1e-9);
}

TEST(AFreeExhibit, IsLookedAtFromBesideItHoweverLargeItIs) {
  const MuseumFolder folder;
  add_exhibit(folder, "position = [3, 5.5]\nfacing = 0\nsize = [1, 3]\n");
  const Exhibit statue = compiled(folder).exhibits.at(2);

  EXPECT_GE(statue.viewing_point.position.x, 4.5 + 0.25);
}

TEST(AFreeExhibit, TakesNoFloorOnAWallInACaseOrOfSizeNought) {
  const MuseumFolder folder;
  const std::size_t walls = compiled(folder).floors.at(0).plan.vertex.size();
  add_exhibit(folder, "position = [3, 6]\nfacing = 0\nsize = 0\n");

  EXPECT_EQ(compiled(folder).floors.at(0).plan.vertex.size(), walls) << "a mosaic to walk over";
  add_exhibit(folder, "position = [3, 0]\nfacing = 90\nsize = 1\n");
  EXPECT_EQ(compiled(folder).floors.at(0).plan.vertex.size(), walls) << "on a wall";
  add_exhibit(folder, "position = [6.4, 4.3]\nfacing = 270\nsize = 1\n");
  EXPECT_EQ(compiled(folder).floors.at(0).plan.vertex.size(), walls) << "in the case of the plan";
}

TEST(ACase, IsDrawnOnceAndWhatStandsInItMovesWithIt) {
  const MuseumFolder folder;
  folder.replace("museum.toml", "[[room]]",
                 "[[case]]\nid = \"shelf\"\nposition = [4, 6]\nsize = [2, 0.6]\n[[room]]");
  add_exhibit(folder, "in = \"shelf\"\nposition = [0.5, 0]\n");
  const Exhibit before = compiled(folder).exhibits.at(2);
  folder.replace("museum.toml", "[4, 6]", "[4, 5]");
  const Museum museum = compiled(folder);
  const Exhibit& after = museum.exhibits.at(2);

  EXPECT_EQ(before.place, ExhibitPlace::InCase);
  EXPECT_EQ(museum.floors.at(0).plan.ring.size(), 4U) << "two rooms, a hole and the case";
  EXPECT_NEAR(before.placement.position.x, 4.5, 1e-12);
  EXPECT_NEAR(glm::distance(after.placement.position, before.placement.position - Vec2(0, 1)), 0,
              1e-12);
  EXPECT_NEAR(
      glm::distance(after.viewing_point.position, before.viewing_point.position - Vec2(0, 1)), 0,
      1e-9);
}

}  // namespace
}  // namespace docent::compile::standing_test
