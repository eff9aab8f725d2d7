#include "content/floor/mend.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "content/content_error.h"
#include "content/floor/crossings.h"
#include "content/floor/voronoi.h"
#include "tests/content/floor/plans.h"
#include "tests/support/reference_data.h"

namespace docent::test::mend_test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const Points hall = rectangle({0, 0}, {20, 12});
const Points plinth = {{5, 4}, {5, 6}, {8, 6}, {8, 4}};

struct Mended {
  FloorPlan plan;
  std::vector<Diagnostic> mendings;
};

Mended mend_all(const import::ImportedPlan& plan) {
  Mended result;
  result.plan = floor::mend(plan, result.mendings);
  return result;
}

void expect_invariants(const FloorPlan& plan) {
  ASSERT_EQ(plan.next.size(), plan.vertex.size());
  std::size_t counted = 0;
  for (const Ring& ring : plan.ring) {
    EXPECT_EQ(ring.first, counted);
    EXPECT_GE(ring.count, 3U);
    for (std::uint32_t i = 0; i < ring.count; ++i) {
      const std::uint32_t v = ring.first + i;
      EXPECT_EQ(plan.next[v], ring.first + (i + 1) % ring.count);
      EXPECT_GT(glm::distance(plan.vertex[v], plan.vertex[plan.next[v]]), 1e-4);
    }
    counted += ring.count;
  }
  EXPECT_EQ(counted, plan.vertex.size());
}

TEST(Mend, LeavesACleanPlanAsItWasDrawnToTheLastBit) {
  const Points outer = {{0.1, 0.2}, {1e6 / 3, 0.30000000000000004}, {1e6 / 7, 12.7}, {0.1, 9.1}};
  import::ImportedPlan plan = drawn(outer, {{{5.05, 4.1}, {5.15, 6.3}, {8.2, 4.7}}});
  for (import::ImportedRing* ring : {&plan.polygons[0].outer, &plan.polygons[0].holes[0]})
    for (Vec2& vertex : ring->vertex) vertex.x /= 1e4;  // No coordinate is a round number.
  const auto [mended_plan, mendings] = mend_all(plan);
  EXPECT_THAT(mendings, IsEmpty());
  Points all = plan.polygons[0].outer.vertex;
  all.insert(all.end(), plan.polygons[0].holes[0].vertex.begin(),
             plan.polygons[0].holes[0].vertex.end());
  EXPECT_EQ(mended_plan.vertex, all);
  expect_invariants(mended_plan);
}

TEST(Mend, DropsCornersThatAreExactlyStraightWithoutAWord) {
  const auto [plan, mendings] =
      mend_all(drawn({{0, 0}, {5, 0}, {10, 0}, {20, 0}, {20, 12}, {10, 12}, {0, 12}, {0, 6}}));
  EXPECT_THAT(mendings, IsEmpty());
  EXPECT_EQ(plan.vertex.size(), 4U);
}

/// A wall of a turned plan is drawn through a point that its doubles cannot hit.
TEST(Mend, DropsCornersThatAreStraightButForARoundingError) {
  for (int i = 1; i < 200; ++i) {
    const double turn = i * 0.03;
    const auto turned = [turn](double x, double y) {
      return Vec2{x * std::cos(turn) - y * std::sin(turn), x * std::sin(turn) + y * std::cos(turn)};
    };
    const auto [plan, mendings] = mend_all(drawn({turned(0, 0), turned(3, 0), turned(7.7, 0),
                                                  turned(20, 0), turned(20, 12), turned(0, 12)}));
    EXPECT_THAT(mendings, IsEmpty());
    EXPECT_EQ(plan.vertex.size(), 4U) << turn;
  }
}

TEST(Mend, TurnsRingsRoundSoThatTheFloorIsOnTheLeft) {
  const auto [plan, mendings] =
      mend_all(drawn({{0, 12}, {20, 12}, {20, 0}, {0, 0}}, {{{8, 4}, {8, 6}, {5, 6}, {5, 4}}}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("ring-runs-backwards", "ring-runs-backwards"));
  EXPECT_DOUBLE_EQ(floor_area(plan), 234);
  EXPECT_GT(signed_area({plan.vertex.begin(), plan.vertex.begin() + 4}), 0);
  EXPECT_LT(signed_area({plan.vertex.begin() + 4, plan.vertex.end()}), 0);
}

TEST(Mend, MakesOneOfCornersCloserThanAMillimetre) {
  const auto [plan, mendings] =
      mend_all(drawn({{0, 0}, {20, 0}, {20, 0.0005}, {20, 12}, {0, 12}, {0, 12}}, {plinth}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("nearly-coincident-corners", "repeated-corner"));
  EXPECT_EQ(mendings[0].line, 1U);
  EXPECT_EQ(mendings[0].column, 3U);
  EXPECT_THAT(mendings[0].message, HasSubstr("0.5 mm"));
  EXPECT_EQ(plan.vertex.size(), 8U);
}

TEST(Mend, KeepsCornersThatAreAMillimetreApart) {
  const Points speck = {{5, 4}, {5, 4.001}, {5.001, 4.001}, {5.001, 4}};
  const auto [plan, mendings] = mend_all(drawn(hall, {speck}));
  EXPECT_THAT(mendings, IsEmpty());
  EXPECT_EQ(plan.vertex.size(), 8U);
}

TEST(Mend, CutsSpikesOffAndSaysWhere) {
  const auto [plan, mendings] =
      mend_all(drawn({{0, 0}, {20, 0}, {20, 6}, {25, 6}, {20, 6}, {20, 12}, {0, 12}}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("spike"));
  EXPECT_EQ(mendings[0].column, 4U);
  EXPECT_EQ(plan.vertex, hall);
}

TEST(Mend, LeavesOutAWallWithoutThickness) {
  for (const Points& wall : {Points{{5, 4}, {8, 4}, {5, 4}}, Points{{5, 2}, {5, 8}}}) {
    const auto [plan, mendings] = mend_all(drawn(hall, {wall}));
    EXPECT_THAT(codes_of(mendings), Contains("ring-without-area"));
    EXPECT_EQ(plan.vertex, hall);
  }
}

TEST(Mend, CountsBothHalvesOfABowTie) {
  const auto [plan, mendings] = mend_all(drawn({{0, 0}, {20, 12}, {20, 0}, {0, 12}}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("ring-crosses-itself"));
  EXPECT_THAT(mendings[0].message, HasSubstr("[10.000, 6.000]"));
  EXPECT_EQ(plan.ring.size(), 2U);
  EXPECT_DOUBLE_EQ(floor_area(plan), 120);
}

TEST(Mend, CountsWhatARingWindsAboutTwice) {
  // A pentagram: even-odd filling would leave a hole in the middle.
  Points star = regular_polygon({10, 10}, 5, 5);
  star = {star[0], star[2], star[4], star[1], star[3]};
  const auto [plan, mendings] = mend_all(drawn(star));
  EXPECT_THAT(codes_of(mendings), ElementsAre("ring-crosses-itself"));
  EXPECT_EQ(plan.ring.size(), 1U);
  EXPECT_EQ(plan.vertex.size(), 10U);
  expect_invariants(plan);
}

TEST(Mend, MakesACaseAgainstTheWallPartOfTheWall) {
  const auto [plan, mendings] = mend_all(drawn(hall, {{{5, 0}, {5, 3}, {8, 3}, {8, 0}}}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("hole-meets-wall"));
  EXPECT_EQ(mendings[0].line, 2U);
  EXPECT_EQ(plan.ring.size(), 1U);
  EXPECT_DOUBLE_EQ(floor_area(plan), 231);
}

TEST(Mend, LetsNobodyThroughWhereTwoCasesTouchInACorner) {
  const auto [plan, mendings] = mend_all(drawn(hall, {plinth, {{8, 6}, {8, 8}, {11, 8}, {11, 6}}}));
  EXPECT_THAT(codes_of(mendings), ElementsAre("holes-meet"));
  // One ring goes round both and comes by the shared corner twice.
  ASSERT_EQ(plan.ring.size(), 2U);
  EXPECT_EQ(plan.ring[1].count, 8U);
  EXPECT_EQ(std::ranges::count(plan.vertex, Vec2{8, 6}), 2);
  EXPECT_EQ(count_holes(plan), 2);
}

TEST(Mend, UnitesRoomsOfSeveralFilesAtTheirSharedBorder) {
  import::ImportedPlan plan = drawn(rectangle({0, 0}, {5, 4}));
  const import::ImportedPlan other = drawn(rectangle({5, 1}, {9, 3}));
  plan.files.push_back("other.geojson");
  plan.polygons.push_back(other.polygons[0]);
  const auto [united, mendings] = mend_all(plan);
  EXPECT_THAT(mendings, IsEmpty());
  EXPECT_EQ(united.ring.size(), 1U);
  EXPECT_EQ(united.vertex.size(), 8U);
  EXPECT_DOUBLE_EQ(floor_area(united), 28);
}

TEST(Mend, SaysWhichHolesHaveNoEffect) {
  const auto [plan, mendings] = mend_all(drawn(
      hall, {rectangle({4, 3}, {12, 9}), rectangle({6, 5}, {8, 7}), rectangle({30, 4}, {33, 6})}));
  EXPECT_THAT(codes_of(mendings),
              ElementsAre("ring-runs-backwards", "ring-runs-backwards", "ring-runs-backwards",
                          "hole-without-effect", "hole-outside-floor"));
  EXPECT_DOUBLE_EQ(floor_area(plan), 192);
}

TEST(Mend, RefusesAPlanWithoutFloor) {
  std::vector<Diagnostic> mendings;
  EXPECT_THROW(floor::mend(drawn(hall, {hall}), mendings), content::ContentError);
  EXPECT_THROW(floor::mend(drawn({{0, 0}, {10, 0}}), mendings), content::ContentError);
}

TEST(Mend, RefusesDegreesThatPoseAsMetres) {
  std::vector<Diagnostic> mendings;
  try {
    floor::mend(drawn(rectangle({-122.38, 37.61}, {-122.37977, 37.6101})), mendings);
    FAIL() << "compiled a plan of 0.0002 m";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "not-in-metres");
    EXPECT_THAT(error.hint, HasSubstr("wgs84"));
  }
}

TEST(Mend, RefusesARingWhosePointsHaveLostTheirOrderAtOnce) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> anywhere(0, 300);
  Points ring;
  for (int i = 0; i < 20000; ++i) ring.push_back({anywhere(random), anywhere(random)});
  std::vector<Diagnostic> mendings;
  try {
    floor::mend(drawn(ring), mendings);
    FAIL() << "mended a tangle";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "cannot-mend");
    EXPECT_THAT(error.hint, HasSubstr("order"));
  }
}

TEST(Crossings, AreEstimatedWithinATenthForManySides) {
  std::vector<floor::OverlayRing> bars;
  for (int i = 0; i < 1000; ++i) {
    const double at = i / 10.0;
    bars.push_back({{{-1, at}, {101, at}, {101, at + 0.05}, {-1, at + 0.05}}});
    bars.push_back({{{at, -1}, {at, 101}, {at + 0.05, 101}, {at + 0.05, -1}}});
  }

  const floor::Crossings found = floor::estimate_crossings(bars);

  EXPECT_NEAR(found.count, 4e6, 4e5);
  EXPECT_EQ(found.of_that_side, 2000U);
}

TEST(Crossings, AreCountedWhereSidesAreFew) {
  const std::vector<floor::OverlayRing> bow_tie{{{{0, 0}, {4, 4}, {4, 0}, {0, 4}}}};
  EXPECT_EQ(floor::estimate_crossings(bow_tie).count, 1);
  EXPECT_EQ(floor::estimate_crossings({}).count, 0);
}

TEST(Mend, LeavesNoTraceOfASpeckThatTouchesAWall) {
  // A wedge of 15 square centimetres, whose tip lies on the hall's wall.
  import::ImportedPlan plan = drawn(hall);
  plan.polygons.push_back(drawn({{20, 5}, {23, 5}, {23, 5.001}}).polygons[0]);
  const auto [mended_plan, mendings] = mend_all(plan);
  EXPECT_THAT(codes_of(mendings), ElementsAre("speck-of-floor"));
  EXPECT_EQ(mended_plan.vertex, hall);
}

TEST(Mend, KeepsACaseThatASpeckOfFloorTouchesFromWithin) {
  import::ImportedPlan plan = drawn(hall, {{{5, 5}, {6, 6}, {7, 5}, {6, 4}}});
  plan.polygons.push_back(drawn({{5, 5}, {5.06, 4.97}, {5.06, 5.03}}).polygons[0]);
  const auto [mended_plan, mendings] = mend_all(plan);
  EXPECT_THAT(codes_of(mendings), Contains("speck-of-floor"));
  EXPECT_DOUBLE_EQ(floor_area(mended_plan), 238);
}

/// In decimals, a corner on an oblique wall misses it by a rounding error, to either side.
TEST(Mend, JoinsACornerThatIsDrawnOnAnObliqueWallToIt) {
  for (int i = 20; i < 180; ++i) {
    const double t = i / 200.0;
    const Vec2 on_wall = Vec2{0.3, 0.7} + t * Vec2{18.4, 9.7};
    const auto [plan, mendings] =
        mend_all(drawn({{0.3, 0.7}, {18.7, 10.4}, {0.3, 10.4}},
                       {{on_wall, on_wall + Vec2{-0.31, 0.01}, on_wall + Vec2{-0.2, 0.13}}}));
    expect_invariants(plan);
    EXPECT_EQ(plan.ring.size(), 1U) << on_wall.x << ' ' << on_wall.y;
    EXPECT_NO_THROW(floor::voronoi_diagram(plan)) << on_wall.x << ' ' << on_wall.y;
  }
}

TEST(Mend, LeavesASlitOfAHundredthOfAMillimetreOpen) {
  const Vec2 above = Vec2{9.5, 5.55} + 1e-5 * Vec2{-9.7, 18.4} / std::hypot(9.7, 18.4);
  const auto [plan, mendings] =
      mend_all(drawn({{0.3, 0.7}, {18.7, 10.4}, {0.3, 10.4}},
                     {{above, above + Vec2{-0.31, 0.01}, above + Vec2{-0.2, 0.13}}}));
  EXPECT_EQ(plan.ring.size(), 2U);
  EXPECT_NO_THROW(floor::voronoi_diagram(plan));
}

TEST(Mend, SettlesWhenRoundedCrossingsCrossAgain) {
  // Fifty thin needles through one point: every rounded crossing lies beside other needles.
  std::vector<Points> needles;
  for (int i = 0; i < 50; ++i) {
    const double angle = 0.0625 * i;
    const Vec2 along = 5.0 * Vec2{std::cos(angle), std::sin(angle)};
    const Vec2 across = 0.001 * left_of(along);
    const Vec2 centre{10 + 1e-9 * i, 6};
    needles.push_back({centre - along, centre + across, centre + along, centre - across});
  }
  const auto [plan, mendings] = mend_all(drawn(hall, needles));
  expect_invariants(plan);
  // Mending what is mended changes nothing.
  import::ImportedPlan again;
  again.files = {"again.geojson"};
  again.polygons.resize(1);
  for (const Ring& ring : plan.ring) {
    import::ImportedRing copy;
    copy.vertex.assign(plan.vertex.begin() + ring.first,
                       plan.vertex.begin() + ring.first + ring.count);
    copy.place.resize(copy.vertex.size());
    if (signed_area(copy.vertex) > 0)
      again.polygons[0].outer = copy;
    else
      again.polygons[0].holes.push_back(copy);
  }
  EXPECT_EQ(mended(again).vertex.size(), plan.vertex.size());
}

/// The reference data's malformed plans, each with what is to become of it.
TEST(Mend, DoesWhatIsExpectedOfEveryMalformedPlan) {
  NEEDS_REFERENCE_DATA("floorplans/nasty");
  int checked = 0;
  for (const auto& file : plan_files("floorplans/nasty")) {
    if (file.stem() == "d30-nan-coordinate") continue;  // Never gets past the reader.
    SCOPED_TRACE(file.filename().string());
    const Polymap map = read_polymap(file);
    std::vector<Diagnostic> mendings;
    try {
      const FloorPlan plan = floor::mend(map.plan, mendings);
      EXPECT_FALSE(map.must_fail);
      expect_invariants(plan);
      if (map.free_area >= 0) {
        EXPECT_NEAR(floor_area(plan), map.free_area, 1e-6);
      }
      if (map.components >= 0) {
        EXPECT_EQ(count_components(plan), map.components);
      }
      if (map.holes >= 0) {
        EXPECT_EQ(count_holes(plan), map.holes);
      }
    } catch (const content::ContentError& error) {
      EXPECT_FALSE(map.accept) << error.what();
    }
    ++checked;
  }
  EXPECT_GE(checked, 30);
}

std::string refusal_of(const import::ImportedPlan& plan) {
  try {
    mend_all(plan);
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.code, "no-floor");
    return error.what();
  }
  return "";
}

TEST(Mend, BlamesWhatLeavesNoFloorAndNothingElse) {
  const Points there_and_back = {{0, 0}, {12, 0}, {6, 0}};
  const Points needle = {{0, 0}, {12, 0}, {12, 0.0015}};

  EXPECT_THAT(refusal_of(drawn(there_and_back)), HasSubstr("no outline encloses an area"));
  EXPECT_THAT(refusal_of(drawn(there_and_back, {plinth})),
              HasSubstr("no outline encloses an area"));
  EXPECT_THAT(refusal_of(drawn(needle)), HasSubstr("largest piece of floor has 90 cm2"));
  EXPECT_THAT(refusal_of(drawn(hall, {rectangle({-1, -1}, {21, 13})})),
              HasSubstr("its holes cover its areas"));
}

TEST(Mend, TellsAHoleThatCoversItsAreaFromOneOutsideTheFloor) {
  import::ImportedPlan plan = drawn(rectangle({30, 0}, {40, 9}), {rectangle({29, -1}, {41, 10})});
  plan.polygons.push_back(drawn(hall, {rectangle({50, 0}, {51, 1})}).polygons[0]);

  const std::vector<std::string> codes = codes_of(mend_all(plan).mendings);

  EXPECT_EQ(std::ranges::count(codes, "hole-covers-area"), 1);
  EXPECT_EQ(std::ranges::count(codes, "hole-outside-floor"), 1);
}

TEST(Mend, TellsWhatItLeftOutOfAPlanThatItRefuses) {
  std::vector<Diagnostic> mendings;

  EXPECT_THROW(floor::mend(drawn({{0, 0}, {12, 0}, {6, 0}}), mendings), content::ContentError);

  EXPECT_THAT(codes_of(mendings), Contains("ring-without-area"));
}

}  // namespace
}  // namespace docent::test::mend_test
