// What giving way is made of: trajectories, passages, refuges, detours.
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <array>
#include <cmath>

#include "runtime/crowd/find_detour.h"
#include "runtime/crowd/find_passage.h"
#include "runtime/crowd/find_refuge.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/guide/situations.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::trajectory_test {
namespace {

constexpr double radius = 0.25;

crowd::Trajectory straight_trajectory(Vec2 from, Vec2 to, double start, double speed = 1) {
  crowd::Trajectory trajectory{start, {from}};
  const double length = glm::distance(from, to);
  for (double walked = 0; walked < length;) {
    walked = std::min(length, walked + speed * crowd::Trajectory::step);
    trajectory.place.push_back(glm::mix(from, to, walked / length));
  }
  return trajectory;
}

struct Hall {
  explicit Hall(const FloorPlan& plan)
      : floor(floor_of(plan, {radius, radius + 0.02})), map(path::make_floor_map(floor)) {}
  Floor floor;
  std::shared_ptr<const path::FloorMap> map;
  crowd::ReservationTable reservations{radius};
};

TEST(Trajectory, StandsBeforeItsBeginningAndAfterItsEnd) {
  const crowd::Trajectory trajectory = straight_trajectory({0, 0}, {3, 0}, 10);

  EXPECT_EQ(crowd::place_at(trajectory, 0), Vec2(0, 0));
  EXPECT_NEAR(crowd::place_at(trajectory, 11.5).x, 1.5, 1e-9);
  EXPECT_EQ(crowd::place_at(trajectory, 99), Vec2(3, 0));
}

RC_GTEST_PROP(Trajectory, MeetsAnotherWhenTryingEveryMomentSaysSo, ()) {
  const auto place = [] {
    return Vec2(*rc::gen::inRange(0, 800) / 100.0, *rc::gen::inRange(0, 800) / 100.0);
  };
  const auto trajectory = [&] {
    crowd::Trajectory it{*rc::gen::inRange(0, 300) / 100.0, {place()}};
    const int steps = *rc::gen::inRange(0, 200);
    const double angle = *rc::gen::inRange(0, 628) / 100.0, bend = *rc::gen::inRange(-5, 6) / 100.0;
    for (int i = 0; i < steps; ++i)
      it.place.push_back(it.place.back() +
                         0.04 * Vec2(std::cos(angle + bend * i), std::sin(angle + bend * i)));
    return it;
  };
  const crowd::Trajectory a = trajectory(), b = trajectory();
  const double distance = 0.5;

  const auto meeting = crowd::first_impact(a, b, distance, 0);

  const double end = std::max(a.end(), b.end()) + 0.1;
  const auto apart = [&](double t) {
    return glm::distance(crowd::place_at(a, t), crowd::place_at(b, t));
  };
  std::optional<double> tried;
  for (double t = 0; t <= end && !tried; t += 1e-3)
    if (apart(t) < distance - 1e-9) tried = t;
  if (tried) {
    RC_ASSERT(meeting.has_value());
    RC_ASSERT(*meeting <= *tried + 1e-6);
    // Whoever stands at just that distance may count as met before they come nearer.
    RC_ASSERT(*meeting > *tried - 1.1e-3 || apart(*meeting) <= distance + 1e-9);
  } else if (meeting) {  // between two of the moments tried
    RC_ASSERT(apart(*meeting) < distance + 1e-3);
  }
}

TEST(ReservationTable, KnowsWhomOneWouldMeetFirst) {
  crowd::ReservationTable reservations(radius);
  reservations.put(1, crowd::standing_trajectory({5, 0}));
  reservations.put(2, crowd::standing_trajectory({3, 0}));
  reservations.put(3, crowd::standing_trajectory({3, 2}));

  const auto conflict =
      reservations.first_conflict(0, straight_trajectory({0, 0}, {6, 0}, 0), 0, 0);

  ASSERT_TRUE(conflict);
  EXPECT_EQ(conflict->body, 2U);
  EXPECT_NEAR(conflict->seconds, 2.5, 1e-6);
  reservations.remove(2);
  EXPECT_EQ(reservations.first_conflict(0, straight_trajectory({0, 0}, {6, 0}, 0), 0, 0)->body, 1U);
  EXPECT_FALSE(reservations.first_conflict(0, crowd::standing_trajectory({0, 0}), 0, 0));
}

crowd::PassageQuery along(const std::vector<Vec2>& way) {
  static constexpr std::array<std::uint32_t, 2> everybody{1, 7};
  crowd::PassageQuery query;
  query.way = way;
  query.near = everybody;
  return query;
}

TEST(FindPassage, IsTheWayItselfWhereNobodyIsNear) {
  Hall hall(head_on_in_a_corridor().plan);
  const std::vector<Vec2> way{{1, 0.7}, {8, 0.7}};

  const crowd::Passage passage = crowd::find_passage(*hall.map, hall.reservations, along(way));

  EXPECT_TRUE(passage.is_straight);
  EXPECT_TRUE(passage.reaches_goal);
}

TEST(FindPassage, PassesOnTheRightWhoComesTowardsItOnTheirs) {
  Hall hall(head_on_in_a_corridor().plan);
  hall.reservations.put(1, straight_trajectory({8, 1.08}, {1, 1.08}, 0));
  const std::vector<Vec2> way{{1, 0.7}, {8, 0.7}};

  const crowd::Passage passage = crowd::find_passage(*hall.map, hall.reservations, along(way));

  EXPECT_TRUE(passage.reaches_goal);
  double lowest = 1;
  for (const Vec2 p : passage.points) lowest = std::min(lowest, p.y);
  EXPECT_LT(lowest, 0.5);
  EXPECT_GE(lowest, radius);
}

TEST(FindPassage, TakesWhoIsNotSaidToBeNearToBeFarAway) {
  Hall hall(head_on_in_a_corridor().plan);
  hall.reservations.put(1, straight_trajectory({8, 0.7}, {1, 0.7}, 0));
  const std::vector<Vec2> way{{1, 0.7}, {8, 0.7}};
  crowd::PassageQuery query = along(way);

  EXPECT_FALSE(crowd::find_passage(*hall.map, hall.reservations, query).is_straight);
  query.near = {};
  EXPECT_TRUE(crowd::find_passage(*hall.map, hall.reservations, query).is_straight);
}

TEST(FindPassage, WaitsWhereItIsSafeUntilANarrowPlaceIsFree) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.reservations.put(1, straight_trajectory({7, 2.5}, {1, 1}, 0));
  const std::vector<Vec2> way{{4, 2.5}, {8, 2.5}};

  const crowd::Passage passage = crowd::find_passage(*hall.map, hall.reservations, along(way));

  EXPECT_FALSE(passage.reaches_goal);
  const crowd::Trajectory other = *hall.reservations.trajectory_of(1);
  for (const std::uint32_t i : passage.stop) {
    if (i == 0) continue;
    const auto met = crowd::first_impact(other, crowd::standing_trajectory(passage.points[i]),
                                         2 * radius, static_cast<double>(i));
    EXPECT_FALSE(met) << i;
  }
}

TEST(FindPassage, SaysWhoHasToMakeRoom) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.reservations.put(7, crowd::standing_trajectory({5.1, 2.5}));
  const std::vector<Vec2> way{{3, 2.5}, {8, 2.5}};
  const std::vector<std::uint32_t> yields_when_asked{7};
  crowd::PassageQuery query = along(way);
  query.yields_when_asked = yields_when_asked;

  const crowd::Passage passage = crowd::find_passage(*hall.map, hall.reservations, query);

  EXPECT_EQ(passage.in_the_way, yields_when_asked);
}

TEST(FindRefuges, StandClearOfTheLineOfOthersAndOfWalls) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.reservations.put(1, crowd::standing_trajectory({4.5, 3.5}));
  const std::vector<Vec2> line{{1, 2.5}, {9, 2.5}};

  const auto refuges = crowd::find_refuges(*hall.map, hall.reservations, 0, {5.1, 2.5}, line, 5);

  ASSERT_FALSE(refuges.empty());
  for (const crowd::Refuge& refuge : refuges) {
    EXPECT_GE(std::abs(refuge.place.y - 2.5), 2 * radius);
    EXPECT_GE(glm::distance(refuge.place, Vec2(4.5, 3.5)), 2 * radius);
    EXPECT_GE(path::clearance_at(*hall.map, refuge.place), radius);
  }
}

TEST(FindDetour, LeadsThroughTheOtherDoor) {
  Hall hall(two_rooms_with_a_door(0.9, true));
  hall.reservations.put(1, crowd::standing_trajectory({5.1, 2.5}));
  path::RouteQuery query;
  query.from = {3, 2.5};
  query.to = {7.5, 2.5};
  query.radius = radius;

  const path::Way way = crowd::find_detour(*hall.map, hall.reservations, 0, query, 0);

  ASSERT_EQ(way.status, path::RouteStatus::Ok);
  EXPECT_GT(way.length, 4.6);
  for (const Vec2 p : way.points) EXPECT_GE(glm::distance(p, Vec2(5.1, 2.5)), 2 * radius);
}

TEST(FindDetour, DoesNotExistWhereThereIsOneDoorOnly) {
  Hall hall(two_rooms_with_a_door(0.9));
  hall.reservations.put(1, crowd::standing_trajectory({5.1, 2.5}));
  path::RouteQuery query;
  query.from = {3, 2.5};
  query.to = {7.5, 2.5};
  query.radius = radius;

  EXPECT_NE(crowd::find_detour(*hall.map, hall.reservations, 0, query, 0).status,
            path::RouteStatus::Ok);
}

}  // namespace
}  // namespace docent::test::trajectory_test
