#include "content/floor/footprint.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <numbers>
#include <vector>

#include "content/content_error.h"
#include "content/floor/voronoi.h"
#include "runtime/model/geometry/door_leaf.h"
#include "runtime/model/geometry/polygon.h"
#include "runtime/model/geometry/segment.h"
#include "tests/content/floor/diagram_check.h"
#include "tests/content/floor/random_plan.h"

namespace docent::floor::footprint_test {
namespace {

using test::drawn;
using test::mended;
using test::rectangle;

/// On a grid of 10 cm and 15 degrees, so that they often touch walls and each other.
rc::Gen<Footprint> any_footprint() {
  return rc::gen::map(
      rc::gen::tuple(rc::gen::inRange(-5, 125), rc::gen::inRange(-5, 85), rc::gen::inRange(0, 24),
                     rc::gen::inRange(1, 30), rc::gen::inRange(1, 30)),
      [](const auto& drawn) {
        const auto [x, y, turned, across, deep] = drawn;
        return Footprint{.centre = {x / 10.0, y / 10.0},
                         .heading = turned * std::numbers::pi / 12,
                         .size = {across / 10.0, deep / 10.0}};
      });
}

double distance_to_edge_of(const Footprint& footprint, Vec2 p) {
  const auto corners = corners_of(footprint);
  double least = 1e9;
  for (std::size_t i = 0; i < 4; ++i)
    least = std::min(least, distance_to_segment(p, corners[i], corners[(i + 1) % 4]));
  return least;
}

TEST(AFootprint, IsTurnedWithItsFrontAndRunsCounterClockwise) {
  const Footprint shelf{.centre = {3, 2}, .heading = std::numbers::pi / 2, .size = {2, 0.5}};

  EXPECT_NEAR(signed_area(corners_of(shelf)), 1, 1e-12);
  EXPECT_TRUE(covers(shelf, {3.9, 2.2})) << "across its front, which looks north, is east and west";
  EXPECT_FALSE(covers(shelf, {3, 2.3}));
  EXPECT_NEAR(distance_to(shelf, {3, 3.25}), 1, 1e-12);
  EXPECT_NEAR(distance_to_edge(shelf, {0, 1}), 0.25, 1e-12);
  EXPECT_NEAR(distance_to_edge(shelf, {1, 0}), 1, 1e-12);
}

TEST(Footprints, OverlapByWhatTheyWouldHaveToBeMoved) {
  const Footprint a{.centre = {0, 0}, .heading = 0, .size = {1, 1}};

  EXPECT_NEAR(overlap_of(a, {.centre = {0.8, 0.1}, .heading = 0, .size = {1, 1}}), 0.2, 1e-12);
  EXPECT_EQ(overlap_of(a, {.centre = {1.1, 0}, .heading = 0, .size = {1, 1}}), 0);
  const Footprint turned{.centre = {1.1, 1.1}, .heading = std::numbers::pi / 4, .size = {1, 1}};
  EXPECT_EQ(overlap_of(a, turned), 0) << "their boxes overlap, they do not";
}

RC_GTEST_PROP(Footprints, ArePartOfEachOtherWhereACornerOfOneIsInTheOther, ()) {
  const Footprint a = *any_footprint(), b = *any_footprint();

  const double overlap = overlap_of(a, b);

  RC_ASSERT(std::abs(overlap - overlap_of(b, a)) < 1e-9);
  for (const Vec2 corner : corners_of(a))
    if (covers(b, corner) && distance_to_edge_of(b, corner) > 1e-6) RC_ASSERT(overlap > 0);
  Footprint moved = b;
  moved.centre += Vec2{40, 0};
  RC_ASSERT(overlap_of(a, moved) == 0);
}

RC_GTEST_PROP(Footprints, AreObstaclesAndNothingElseChanges, ()) {
  const auto footprints = *rc::gen::container<std::vector<Footprint>>(any_footprint());
  FloorPlan hall = mended(drawn(rectangle({0, 0}, {12, 8}), {rectangle({5, 3}, {6, 4})}));
  hall.name = "hall";
  const Vec2 point{*rc::gen::inRange(-100, 1300) / 100.0, *rc::gen::inRange(-100, 900) / 100.0};
  const auto is_near_an_edge = [&](const Footprint& f) {
    return distance_to_edge_of(f, point) < 0.002;
  };
  const auto is_covering = [&](const Footprint& f) { return covers(f, point); };
  RC_PRE(std::ranges::none_of(footprints, is_near_an_edge));
  // Something of the hall is left over.
  const Vec2 corner{0.01, 0.01};
  RC_PRE(std::ranges::none_of(footprints,
                              [&](const Footprint& f) { return distance_to(f, corner) < 0.1; }));

  const FloorPlan furnished = with_obstacles(hall, footprints);

  RC_ASSERT(furnished.name == "hall");
  const bool was_walkable = is_walkable(hall, point);
  const bool is_free = was_walkable && std::ranges::none_of(footprints, is_covering);
  // Pieces of floor that are too small to stand on are left out.
  if (is_walkable(furnished, point)) RC_ASSERT(is_free);
  if (is_free && footprints.size() < 2) RC_ASSERT(is_walkable(furnished, point));
}

RC_GTEST_PROP(Footprints, LeaveAFloorWhoseVoronoiDiagramIsExact, ()) {
  const auto footprints = *rc::gen::container<std::vector<Footprint>>(any_footprint());
  FloorPlan furnished;
  try {
    furnished = with_obstacles(mended(drawn(rectangle({0, 0}, {12, 8}))), footprints);
  } catch (const content::ContentError&) {
    RC_DISCARD("they cover the hall");
  }
  const test::Complaint complaint = test::check(furnished, voronoi_diagram(furnished));
  if (!complaint.empty()) RC_FAIL(complaint);
}

TEST(Footprints, ThatCoverTheWholeFloorAreRefused) {
  const FloorPlan hall = mended(drawn(rectangle({0, 0}, {2, 2})));

  EXPECT_ANY_THROW((void)with_obstacles(
      hall, std::vector<Footprint>{{.centre = {1, 1}, .heading = 0, .size = {3, 3}}}));
}

}  // namespace
}  // namespace docent::floor::footprint_test
