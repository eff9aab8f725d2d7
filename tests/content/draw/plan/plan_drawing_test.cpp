#include "content/draw/plan/plan_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <fstream>
#include <iterator>
#include <string>

#include "content/content_error.h"
#include "content/draw/picture_file.h"
#include "content/draw/plan/plan_labels.h"
#include "content/draw/plan/plan_rings.h"
#include "content/draw/plan/plan_style.h"
#include "content/draw/svg.h"
#include "content/floor/medial_axis.h"
#include "content/floor/mend.h"
#include "content/floor/voronoi.h"
#include "tests/content/floor/plans.h"
#include "tests/support/temporary_folder.h"

namespace docent::test::plan_drawing_test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// An L-shaped room with one exhibit: its corner gives the diagram two parabolas.
Museum small_museum() {
  import::ImportedRing outer;
  outer.vertex = {{0, 0}, {6, 0}, {6, 2}, {2, 2}, {2, 6}, {0, 6}};
  outer.place.resize(outer.vertex.size());
  Museum museum;
  Floor& floor = museum.floors.emplace_back();
  std::vector<Diagnostic> mendings;
  floor.plan = floor::mend({{"l.geojson"}, {{outer, {}}}, {}}, mendings);
  floor.plan.name = "upper & lower";
  floor.diagram = floor::voronoi_diagram(floor.plan);
  floor.roadmap = floor::medial_axis(floor.plan, floor.diagram);
  Exhibit& exhibit = museum.exhibits.emplace_back();
  exhibit.id = "bronze-tripod";
  exhibit.placement.position = {0, 5};
  exhibit.viewing_point.position = {1, 5};
  return museum;
}

std::size_t count(const std::string& text, const std::string& word) {
  std::size_t n = 0;
  for (auto at = text.find(word); at != std::string::npos; at = text.find(word, at + 1)) ++n;
  return n;
}

TEST(PlanDrawing, DrawsOnlyTheLayersAskedFor) {
  const Museum museum = small_museum();
  const std::string exhibits = draw::draw_plan(museum, 0, {.exhibits = true}, {});
  EXPECT_THAT(exhibits, HasSubstr("bronze-tripod"));
  EXPECT_THAT(draw::draw_plan(museum, 0, {.walls = true}, {}), Not(HasSubstr("bronze-tripod")));
}

TEST(PlanDrawing, DrawsEachRegionOnceAndParabolasAsQuadraticCurves) {
  const Museum museum = small_museum();
  const std::string svg = draw::draw_plan(museum, 0, {.regions = true}, {});
  EXPECT_EQ(count(svg, "stroke-width=\"0.5\""), museum.floors[0].diagram.site.size());
  // Each of the two parabolas borders two regions and is drawn once more as a border.
  EXPECT_EQ(count(svg, "Q"), 6U);
}

TEST(PlanDrawing, CoversItsPageToTheLastPixel) {
  const std::string svg = draw::draw_plan(small_museum(), 0, {}, {});

  // The page has whole pixels, so that no edge of it is half transparent.
  const std::size_t paper = svg.find("<rect x=\"0.00\" y=\"0.00\" width=\"");
  ASSERT_NE(paper, std::string::npos);
  const std::string rest = svg.substr(paper, svg.find("/>", paper) - paper);
  EXPECT_THAT(rest, testing::ContainsRegex("width=\"[0-9]+\\.00\" height=\"[0-9]+\\.00\""));
}

TEST(PlanDrawing, EscapesNames) {
  EXPECT_THAT(draw::draw_plan(small_museum(), 0, {}, {}), HasSubstr("upper &amp; lower"));
}

TEST(PlanDrawing, TellsTheThreeKindsOfWaysApart) {
  const Museum museum = small_museum();
  const auto way = [&](RouteKind kind) {
    return draw::draw_plan(museum, 0, {}, {{kind, {{1, 1}, {5, 1}}, false, 0}});
  };
  EXPECT_THAT(way(RouteKind::Shortest), HasSubstr(std::string(draw::ink::vermilion)));
  EXPECT_THAT(way(RouteKind::Skeleton), HasSubstr(std::string(draw::ink::teal)));
  EXPECT_THAT(way(RouteKind::Offset), HasSubstr(std::string(draw::ink::ochre)));
}

TEST(PlanDrawing, DrawsAFurtherKindInItsOwnColourAndPattern) {
  const RouteKindInfo wandering{.kind = RouteKind{3},
                                .name = "wandering",
                                .legend = "wandering path",
                                .colour = 0x123456,
                                .pattern = {.period = 1, .drawn_piece = 2, .drawn_gap = 5}};
  const std::string stroke = draw::way_stroke(wandering, 10);
  EXPECT_THAT(stroke, HasSubstr("#123456"));
  EXPECT_THAT(stroke, HasSubstr("stroke-dasharray=\"20.0 50.0\""));
}

TEST(PlanDrawing, ExplainsWhatItShowsAndNothingElse) {
  const Museum museum = small_museum();
  EXPECT_THAT(draw::draw_plan(museum, 0, {.walls = true}, {}), Not(HasSubstr("Voronoi regions")));
  const std::string svg = draw::draw_plan(museum, 0, {.regions = true, .skeleton = true},
                                          {{std::nullopt, {{1, 1}, {5, 1}, {1, 5}}, true, 0.5},
                                           {RouteKind::Shortest, {{1, 1}, {5, 1}}, false, 0}});
  for (const char* words :
       {"Voronoi regions", "medial axis", "clearance, every 0.5 m", "shortest path"})
    EXPECT_THAT(svg, HasSubstr(words));
  EXPECT_THAT(svg, Not(HasSubstr("reflex corner")));
}

/// A hall of 40 by 30 m with one thing standing in it.
Museum hall_with(const Points& ring) {
  Museum museum;
  std::vector<Diagnostic> mendings;
  museum.floors.emplace_back().plan =
      floor::mend(drawn(rectangle({0, 0}, {40, 30}), {ring}), mendings);
  return museum;
}

TEST(PlanDrawing, ExplainsTheColoursOfItsWalls) {
  const auto legend = [](const Points& ring) {
    return draw::draw_plan(hall_with(ring), 0, {.walls = true}, {});
  };
  const std::string with_case = legend(rectangle({10, 10}, {12, 12})),
                    with_wall = legend(rectangle({10, 10}, {30, 10.4})),
                    with_block = legend(rectangle({10, 10}, {30, 20}));

  for (const std::string& svg : {with_case, with_wall, with_block})
    EXPECT_THAT(svg, HasSubstr("wall, cut through"));
  EXPECT_THAT(with_case, HasSubstr("case, plinth or column"));
  EXPECT_THAT(with_block, HasSubstr("closed block"));
  EXPECT_THAT(with_wall, AllOf(Not(HasSubstr("case,")), Not(HasSubstr("closed block"))));
  EXPECT_THAT(with_wall, Not(HasSubstr("door")));
}

TEST(PlanDrawing, ExplainsTheTwoColoursOfWallsThatAreSites) {
  EXPECT_THAT(draw::draw_plan(small_museum(), 0, {.sites = true}, {}),
              HasSubstr("walls as sites, in turn"));
}

TEST(PlanDrawing, TellsOpenDoorsFromClosedOnes) {
  Museum museum = small_museum();
  museum.floors[0].plan.doors = {{"open", {0, 3}, {2, 3}, false}};
  EXPECT_THAT(draw::draw_plan(museum, 0, {.walls = true}, {}),
              AllOf(HasSubstr(">door<"), Not(HasSubstr("closed door"))));
  museum.floors[0].plan.doors[0].closed = true;
  EXPECT_THAT(draw::draw_plan(museum, 0, {.walls = true}, {}),
              AllOf(Not(HasSubstr(">door<")), HasSubstr("closed door")));
}

TEST(PlanDrawing, HatchesABlockThatFloorRunsRound) {
  const std::string svg =
      draw::draw_plan(hall_with(rectangle({10, 10}, {30, 20})), 0, {.walls = true}, {});

  EXPECT_THAT(svg, HasSubstr("<pattern id=\"block\""));
  EXPECT_EQ(count(svg, "fill=\"url(#block)\""), 2U);  // The block, and its place in the legend.
}

TEST(PlanRings, AreToldApartByTheirSizeAndThickness) {
  const auto role = [](const Points& ring) {
    const Museum museum = hall_with(ring);
    return draw::role_of(museum.floors[0].plan, museum.floors[0].plan.ring.back());
  };
  EXPECT_EQ(role(regular_polygon({10, 10}, 2.9, 12)), draw::RingRole::Case);
  EXPECT_EQ(role(rectangle({10, 10}, {30, 10.4})), draw::RingRole::Partition);
  EXPECT_EQ(role({{10, 10}, {10, 25}, {10.5, 25}, {10.5, 10.5}, {30, 10.5}, {30, 10}}),
            draw::RingRole::Partition);
  EXPECT_EQ(role(rectangle({10, 10}, {30, 20})), draw::RingRole::Block);
}

TEST(PlanDrawing, ShowsARoomWithinABlock) {
  Museum museum = hall_with(rectangle({10, 5}, {30, 25}));
  std::vector<Diagnostic> mendings;
  import::ImportedPlan plan = drawn(rectangle({0, 0}, {40, 30}), {rectangle({10, 5}, {30, 25})});
  plan.polygons.push_back(drawn(rectangle({15, 10}, {25, 20})).polygons[0]);
  museum.floors[0].plan = floor::mend(plan, mendings);

  const std::string svg = draw::draw_plan(museum, 0, {.walls = true}, {});

  // The floor lies over the block, and nothing that is filled over the floor but the legend.
  const std::size_t floor = svg.find("fill-rule=\"evenodd\"");
  EXPECT_LT(svg.find("fill=\"url(#block)\""), floor);
  EXPECT_THAT(svg.substr(floor, svg.find("<rect", floor) - floor), Not(HasSubstr("fill=\"#")));
}

TEST(PlanDrawing, ShadesEachLevelOnceWithItsHolesLeftOut) {
  const Museum museum = small_museum();
  const auto ring = [](double size, double clearance) {
    return draw::DrawnLine{std::nullopt, {{1, 1}, {1 + size, 1}, {1, 1 + size}}, true, clearance};
  };
  const std::string svg = draw::draw_plan(museum, 0, {}, {ring(4, 0.5), ring(1, 0.5), ring(3, 1)});
  EXPECT_EQ(count(svg, "fill-rule=\"evenodd\""), 2U + 3U);  // Three more in the legend.
}

TEST(PlanDrawing, IsTheSameEveryTime) {
  const draw::PlanLayers all{
      .walls = true, .regions = true, .sites = true, .skeleton = true, .exhibits = true};
  EXPECT_EQ(draw::draw_plan(small_museum(), 0, all, {}),
            draw::draw_plan(small_museum(), 0, all, {}));
}

TEST(PlanLabels, HideNeitherMarksNorEachOther) {
  std::vector<draw::Label> labels = {
      {"first", {100, 100}, {}}, {"second", {150, 100}, {}}, {"third", {100, 110}, {}}};
  draw::place_labels(labels, 16, {400, 300});
  for (std::size_t i = 0; i < labels.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const Vec2 apart = glm::abs(labels[i].baseline - labels[j].baseline);
      EXPECT_TRUE(apart.y > 16 || apart.x > 5 * 0.54 * 16) << labels[i].words;
    }
}

TEST(PlanLabels, StayOnThePage) {
  std::vector<draw::Label> labels = {{"at-the-right-edge", {395, 150}, {}}};
  draw::place_labels(labels, 16, {400, 300});
  EXPECT_LT(labels[0].baseline.x, 300);
}

TEST(PictureFile, PaintsWhatTheDrawingSays) {
  const TemporaryFolder folder;
  draw::Svg svg(20, 10);
  svg.rectangle({0, 0}, {20, 10}, "fill=\"#D2452D\"");
  draw::write_picture(folder.path() / "red.png", svg.document());
  std::ifstream stream(folder.path() / "red.png", std::ios::binary);
  const std::string png{std::istreambuf_iterator<char>(stream), {}};
  ASSERT_GT(png.size(), 24U);
  EXPECT_EQ(png.substr(1, 3), "PNG");
  EXPECT_EQ(png[19], 20);  // Width and height, in the header chunk.
  EXPECT_EQ(png[23], 10);
}

TEST(PictureFile, RefusesAnUnknownFormatAndLeavesNothingBehind) {
  const TemporaryFolder folder;
  EXPECT_THROW(draw::write_picture(folder.path() / "plan.bmp", "<svg/>"), content::ContentError);
  EXPECT_THROW(draw::write_picture(folder.path() / "no-such" / "plan.svg", "<svg/>"),
               content::ContentError);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

TEST(Mixed, BlendsColoursChannelByChannel) {
  EXPECT_EQ(draw::mixed("#000000", "#FF8000", 0.5), "#804000");
  EXPECT_EQ(draw::mixed("#102030", "#FFFFFF", 0), "#102030");
}

/// The room twice, joined by a lift and by an escalator that runs upwards.
Museum small_house() {
  Museum museum = small_museum();
  museum.floors.push_back(museum.floors.front());
  museum.floors[0].plan.short_name = "G";
  museum.floors[1].plan.short_name = "1";
  Connection lift;
  lift.id = "lift";
  lift.kind = ConnectionKind::Lift;
  lift.stops = {{.floor = 0, .placement = {{1, 1}, 0}}, {.floor = 1, .placement = {{1, 1}, 0}}};
  Connection escalator = lift;
  escalator.id = "escalator";
  escalator.kind = ConnectionKind::Escalator;
  escalator.direction = ConnectionDirection::Up;
  museum.connections = {lift, escalator};
  return museum;
}

TEST(PlanDrawing, SaysAtEachStopWhereItLeads) {
  const Museum museum = small_house();
  const std::string ground = draw::draw_plan(museum, 0, {.connections = true}, {});
  EXPECT_THAT(ground, AllOf(HasSubstr(">lift to 1<"), HasSubstr(">escalator to 1<")));
  const std::string upper = draw::draw_plan(museum, 1, {.connections = true}, {});
  EXPECT_THAT(upper, AllOf(HasSubstr(">lift to G<"), HasSubstr(">escalator from G<")));
}

TEST(PlanDrawing, MarksAClosedConnection) {
  Museum museum = small_house();
  museum.connections[0].closed = true;
  EXPECT_THAT(draw::draw_plan(museum, 0, {.connections = true}, {}),
              HasSubstr(">lift to 1, closed<"));
}

TEST(PlanDrawing, NumbersTheLinesOfTheGrid) {
  const std::string svg = draw::draw_plan(small_museum(), 0, {.grid = true}, {});
  for (const char* metres : {">0<", ">1<", ">5<", ">6<"}) EXPECT_EQ(count(svg, metres), 2U);
  EXPECT_THAT(svg, Not(HasSubstr(">-0<")));
}

TEST(PlanDrawing, DrawsABuildingsFloorsSideBySideToOneScale) {
  Museum museum = small_house();
  for (Vec2& vertex : museum.floors[1].plan.vertex) vertex = vertex / 2.0;
  const std::string svg = draw::draw_building(museum, {{0, {}}, {1, {}}}, {.walls = true});
  EXPECT_EQ(count(svg, "translate("), 2U);
  EXPECT_EQ(count(svg, "1 m<"), 2U);
}

}  // namespace
}  // namespace docent::test::plan_drawing_test
