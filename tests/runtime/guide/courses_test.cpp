// What giving way is made of: courses, passages, refuges, detours.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>

#include "runtime/crowd/find_detour.h"
#include "runtime/crowd/find_passage.h"
#include "runtime/crowd/find_refuge.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/guide/situations.h"
#include "tests/runtime/path/floors.h"

namespace docent::test {
namespace {

constexpr double radius = 0.25;

Course straight_course(Vec2 from, Vec2 to, double start, double speed = 1) {
  Course course{start, {from}};
  const double length = glm::distance(from, to);
  for (double walked = 0; walked < length;) {
    walked = std::min(length, walked + speed * Course::step);
    course.place.push_back(glm::mix(from, to, walked / length));
  }
  return course;
}

struct Hall {
  explicit Hall(const FloorPlan& plan)
      : floor(floor_of(plan, {radius, radius + 0.02})), map(make_floor_map(floor)) {}
  Floor floor;
  std::shared_ptr<const FloorMap> map;
  Timetable timetable{radius};
};

TEST(Course, StandsBeforeItsBeginningAndAfterItsEnd) {
  const Course course = straight_course({0, 0}, {3, 0}, 10);

  EXPECT_EQ(place_at(course, 0), Vec2(0, 0));
  EXPECT_NEAR(place_at(course, 11.5).x, 1.5, 1e-9);
  EXPECT_EQ(place_at(course, 99), Vec2(3, 0));
}

RC_GTEST_PROP(Course, MeetsAnotherWhenTryingEveryMomentSaysSo, ()) {
  const auto place = [] {
    return Vec2(*rc::gen::inRange(0, 800) / 100.0, *rc::gen::inRange(0, 800) / 100.0);
  };
  const auto course = [&] {
    Course it{*rc::gen::inRange(0, 300) / 100.0, {place()}};
    const int steps = *rc::gen::inRange(0, 200);
    const double angle = *rc::gen::inRange(0, 628) / 100.0, bend = *rc::gen::inRange(-5, 6) / 100.0;
    for (int i = 0; i < steps; ++i)
      it.place.push_back(it.place.back() +
                         0.04 * Vec2(std::cos(angle + bend * i), std::sin(angle + bend * i)));
    return it;
  };
  const Course a = course(), b = course();
  const double distance = 0.5;

  const auto meeting = first_meeting(a, b, distance, 0);

  const double end = std::max(a.end(), b.end()) + 0.1;
  std::optional<double> tried;
  for (double t = 0; t <= end && !tried; t += 1e-3)
    if (glm::distance(place_at(a, t), place_at(b, t)) < distance - 1e-9) tried = t;
  if (tried) {
    RC_ASSERT(meeting.has_value());
    RC_ASSERT(*meeting <= *tried + 1e-6);
    RC_ASSERT(*meeting > *tried - 1.1e-3);
  } else if (meeting) {  // between two of the moments tried
    RC_ASSERT(glm::distance(place_at(a, *meeting), place_at(b, *meeting)) < distance + 1e-3);
  }
}

TEST(Timetable, KnowsWhomOneWouldMeetFirst) {
  Timetable timetable(radius);
  timetable.put(1, standing_course({5, 0}));
  timetable.put(2, standing_course({3, 0}));
  timetable.put(3, standing_course({3, 2}));

  const auto conflict = timetable.first_conflict(0, straight_course({0, 0}, {6, 0}, 0), 0, 0);

  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->body, 2U);
  EXPECT_NEAR(conflict->seconds, 2.5, 1e-6);
  timetable.remove(2);
  EXPECT_EQ(timetable.first_conflict(0, straight_course({0, 0}, {6, 0}, 0), 0, 0)->body, 1U);
  EXPECT_FALSE(timetable.first_conflict(0, standing_course({0, 0}), 0, 0));
}

PassageQuery along(const std::vector<Vec2>& way) {
  PassageQuery query;
  query.way = way;
  return query;
}

TEST(FindPassage, IsTheWayItselfWhereNobodyIsNear) {
  Hall hall(head_on_in_a_corridor().plan);
  const std::vector<Vec2> way{{1, 0.7}, {8, 0.7}};

  const Passage passage = find_passage(*hall.map, hall.timetable, along(way));

  EXPECT_TRUE(passage.is_straight);
  EXPECT_TRUE(passage.reaches_goal);
}

TEST(FindPassage, PassesOnTheRightWhoComesTowardsItOnTheirs) {
  Hall hall(head_on_in_a_corridor().plan);
  hall.timetable.put(1, straight_course({8, 1.08}, {1, 1.08}, 0));
  const std::vector<Vec2> way{{1, 0.7}, {8, 0.7}};

  const Passage passage = find_passage(*hall.map, hall.timetable, along(way));

  EXPECT_TRUE(passage.reaches_goal);
  double lowest = 1;
  for (const Vec2 p : passage.points) lowest = std::min(lowest, p.y);
  EXPECT_LT(lowest, 0.5);
  EXPECT_GE(lowest, radius);
}

TEST(FindPassage, WaitsWhereItIsSafeUntilANarrowPlaceIsFree) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.timetable.put(1, straight_course({7, 2.5}, {1, 1}, 0));
  const std::vector<Vec2> way{{4, 2.5}, {8, 2.5}};

  const Passage passage = find_passage(*hall.map, hall.timetable, along(way));

  EXPECT_FALSE(passage.reaches_goal);
  const Course other = *hall.timetable.course_of(1);
  for (const std::uint32_t i : passage.stop) {
    if (i == 0) continue;
    const auto met = first_meeting(other, standing_course(passage.points[i]), 2 * radius,
                                   static_cast<double>(i));
    EXPECT_FALSE(met) << i;
  }
}

TEST(FindPassage, SaysWhoHasToMakeRoom) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.timetable.put(7, standing_course({5.1, 2.5}));
  const std::vector<Vec2> way{{3, 2.5}, {8, 2.5}};
  const std::vector<std::uint32_t> obliging{7};
  PassageQuery query = along(way);
  query.obliging = obliging;

  const Passage passage = find_passage(*hall.map, hall.timetable, query);

  EXPECT_EQ(passage.in_the_way, obliging);
}

TEST(FindRefuges, StandClearOfTheLineOfOthersAndOfWalls) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.timetable.put(1, standing_course({4.5, 3.5}));
  const std::vector<Vec2> line{{1, 2.5}, {9, 2.5}};

  const auto refuges = find_refuges(*hall.map, hall.timetable, 0, {5.1, 2.5}, line, 5);

  ASSERT_FALSE(refuges.empty());
  for (const Refuge& refuge : refuges) {
    EXPECT_GE(std::abs(refuge.place.y - 2.5), 2 * radius);
    EXPECT_GE(glm::distance(refuge.place, Vec2(4.5, 3.5)), 2 * radius);
    EXPECT_GE(clearance_at(*hall.map, refuge.place), radius);
  }
}

TEST(FindDetour, LeadsThroughTheOtherDoor) {
  Hall hall(two_rooms_with_a_door(0.9, true));
  hall.timetable.put(1, standing_course({5.1, 2.5}));
  RouteQuery query;
  query.from = {3, 2.5};
  query.to = {7.5, 2.5};
  query.radius = radius;

  const Way way = find_detour(*hall.map, hall.timetable, 0, query, 0);

  ASSERT_EQ(way.status, RouteStatus::Ok);
  EXPECT_GT(way.length, 4.6);
  for (const Vec2 p : way.points) EXPECT_GE(glm::distance(p, Vec2(5.1, 2.5)), 2 * radius);
}

TEST(FindDetour, DoesNotExistWhereThereIsOneDoorOnly) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.timetable.put(1, standing_course({5.1, 2.5}));
  RouteQuery query;
  query.from = {3, 2.5};
  query.to = {7.5, 2.5};
  query.radius = radius;

  EXPECT_NE(find_detour(*hall.map, hall.timetable, 0, query, 0).status, RouteStatus::Ok);
}

}  // namespace
}  // namespace docent::test
