// A building of three floors: guides and strollers change floors by stairs, an escalator and a
// lift.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "platform/sqlite/content_reader.h"
#include "runtime/guide/crowd.h"
#include "runtime/guide/strollers.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/route.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/halls.h"
#include "tests/support/sample_database.h"
#include "tests/support/sanitized.h"

namespace docent::guide::floors_test {
namespace {

constexpr double frame = 1.0 / 60;
constexpr double floor_height = 4;

Placement at(double x, double y, double degrees) {
  return {{x, y}, degrees * std::numbers::pi / 180};
}

Floor floor_of(const FloorPlan& plan, std::int32_t ordinal, const Museum& museum) {
  Floor floor =
      test::floor_of(plan, {museum.body_radius + Museum::walking_room, museum.body_radius});
  floor.plan.ordinal = ordinal;
  floor.plan.height = floor_height * ordinal;
  return floor;
}

void add_exhibit(std::uint32_t floor, const Placement& viewing_point, Museum& museum) {
  Exhibit exhibit;
  exhibit.floor = floor;
  exhibit.viewing_point = viewing_point;
  museum.exhibits.push_back(exhibit);
}

/// Three halls of 16 by 10 m, one above the other: stairs in the west from hall to hall, a lift in
/// the east that serves all, an escalator in the north that goes up from the lowest. Where flights
/// are, halls have none of their floor.
Museum house() {
  const Museum sample = sqlite::load_museum(test::sample_database()).value();
  Museum museum;
  museum.motion = sample.motion;
  museum.avatar = sample.avatar;
  museum.body_radius = 0.25;
  test::HallMaker hall;
  hall.room({0, 0}, {16, 10}).block({0.4, 2.6}, {1.6, 6.4}).block({4.6, 8.5}, {10.4, 9.5});
  for (std::int32_t ordinal = 0; ordinal < 3; ++ordinal)
    museum.floors.push_back(floor_of(hall.plan, ordinal, museum));
  const auto stairs = [](std::uint32_t floor) {
    return Connection{.id = "stairs",
                      .kind = ConnectionKind::Stairs,
                      .seconds_per_floor = 16,
                      .metres_per_floor = 8,
                      .stops = {{floor, at(1, 2, 90)}, {floor + 1, at(1, 7, -90)}}};
  };
  museum.connections = {stairs(0),
                        stairs(1),
                        {.id = "lift",
                         .kind = ConnectionKind::Lift,
                         .step_free = true,
                         .wait_seconds = 8,
                         .seconds_per_floor = 4,
                         .stops = {{0, at(15.7, 5, 0)}, {1, at(15.7, 5, 0)}, {2, at(15.7, 5, 0)}}},
                        {.id = "escalator",
                         .kind = ConnectionKind::Escalator,
                         .direction = ConnectionDirection::Up,
                         .seconds_per_floor = 12,
                         .metres_per_floor = 9,
                         .stops = {{0, at(4, 9, 0)}, {1, at(11, 9, 180)}}}};
  for (std::uint32_t floor = 0; floor < 3; ++floor)
    for (int i = 0; i < 8; ++i)
      add_exhibit(floor, at(3 + 3.2 * (i % 4), i < 4 ? 1.5 : 6.5, i < 4 ? -90 : 90), museum);
  museum.kiosk = at(8, 4, 90);
  return museum;
}

/// Where a body is, in the building.
Vec3 place_of(const Avatar& avatar) {
  return {avatar.body.position.x, avatar.body.position.y, avatar.height};
}

/// Sixty frames a second until nobody is on the way, or for so long at most.
class Watch {
 public:
  Watch(const Museum& museum, std::size_t bodies)
      : planner_(museum, {}, bodies), crowd_(museum, planner_) {}

  Crowd& crowd() { return crowd_; }
  plan::Planner& planner() { return planner_; }

  void step(double seconds = frame) {
    planner_.wait();
    before_.clear();
    for (const Agent& one : crowd_.members()) before_.push_back(place_of(one.avatar));
    crowd_.step(seconds);
    look();
  }
  bool run_until_arrived(std::uint32_t who, double seconds) {
    for (double t = 0; t < seconds; t += frame) {
      step();
      if (crowd_[who].has_arrived && stands(crowd_[who].avatar)) return true;
    }
    return false;
  }

  double least_apart = 1e9;      ///< Metres between two bodies that are not a storey apart.
  double least_clearance = 1e9;  ///< Metres to a wall, on floors.
  double quickest = 0;           ///< Metres a second, of a centre in the building.
  std::size_t collisions = 0, rides = 0;

 private:
  void look() {
    collisions += crowd_.collisions();
    was_riding_.resize(crowd_.size());
    for (std::uint32_t i = 0; i < crowd_.size(); ++i) {
      const Agent& one = crowd_[i];
      if (!one.is_here) continue;
      const Vec3 place = place_of(one.avatar);
      quickest = std::max(quickest, glm::distance(place, before_[i]) / frame);
      const bool rides_now = ride_of(one.avatar) != nullptr;
      if (rides_now && !was_riding_[i]) ++rides;
      was_riding_[i] = rides_now;
      if (!rides_now)
        least_clearance = std::min(
            least_clearance,
            path::clearance_at(*planner_.maps()[one.avatar.floor], one.avatar.body.position));
      for (std::uint32_t j = 0; j < i; ++j) {
        if (!crowd_[j].is_here) continue;
        const Vec3 other = place_of(crowd_[j].avatar);
        constexpr double body_height = 2;
        if (std::abs(other.z - place.z) < body_height)
          least_apart = std::min(least_apart, glm::distance(Vec2(other), Vec2(place)));
      }
    }
  }

  plan::Planner planner_;
  Crowd crowd_;
  std::vector<Vec3> before_;
  std::vector<bool> was_riding_;
};

TEST(AGuide, WalksUpTwoFloorsAndComesBackWithoutAJump) {
  const Museum museum = house();
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);
  const Exhibit& goal = museum.exhibits.back();

  watch.crowd().send(0, goal.floor, goal.viewing_point, RouteKind::Shortest);
  ASSERT_TRUE(watch.run_until_arrived(0, 180));
  const Avatar& avatar = watch.crowd()[0].avatar;
  EXPECT_EQ(avatar.floor, 2U);
  EXPECT_NEAR(avatar.height, 2 * floor_height, 1e-9);
  EXPECT_LT(glm::distance(avatar.body.position, goal.viewing_point.position), 0.02);

  watch.crowd().send(0, 0, museum.kiosk, RouteKind::Skeleton);
  ASSERT_TRUE(watch.run_until_arrived(0, 180));
  EXPECT_EQ(avatar.floor, 0U);
  EXPECT_LT(glm::distance(avatar.body.position, museum.kiosk.position), 0.02);
  EXPECT_GE(watch.rides, 2U);
  EXPECT_GE(watch.least_clearance, museum.body_radius - 0.01);
  EXPECT_LT(watch.quickest, 2.5);
}

TEST(AGuide, IsToldOfTheWholeWayWithItsStairsAndWaits) {
  const Museum museum = house();
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);
  const path::BuildingMap building(museum, watch.planner().maps());
  for (const Exhibit& goal : museum.exhibits) {
    if (goal.floor == 0) continue;
    const path::BuildingWay way =
        building.route({.way = {.kind = RouteKind::Shortest,
                                .from = museum.kiosk.position,
                                .to = goal.viewing_point.position,
                                .radius = museum.body_radius + Museum::walking_room,
                                .smooth = true,
                                .tell_clearance = false},
                        .from_floor = 0,
                        .to_floor = goal.floor});

    watch.crowd().send(0, goal.floor, goal.viewing_point, RouteKind::Shortest);
    while (!watch.crowd()[0].route_summary) watch.step();

    EXPECT_NEAR(watch.crowd()[0].route_summary->metres, way.length, 1e-6);
    EXPECT_NEAR(watch.crowd()[0].route_summary->seconds, way.seconds, 0.35 * way.seconds);
    watch.crowd().send(0, 0, museum.kiosk, RouteKind::Shortest);
    ASSERT_TRUE(watch.run_until_arrived(0, 180));
  }
}

TEST(AGuide, SentElsewhereOnTheStairsComesOutAndThenTurnsRound) {
  const Museum museum = house();
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);
  const Exhibit& above = museum.exhibits[8];
  watch.crowd().send(0, above.floor, above.viewing_point, RouteKind::Shortest);
  const auto rides = [&] { return ride_of(watch.crowd()[0].avatar) != nullptr; };
  for (int i = 0; i < 60 * 60 && !rides(); ++i) watch.step();
  ASSERT_TRUE(rides());

  watch.crowd().send(0, 0, museum.exhibits[0].viewing_point, RouteKind::Shortest);

  ASSERT_TRUE(watch.run_until_arrived(0, 180));
  EXPECT_EQ(watch.crowd()[0].avatar.floor, 0U);
  EXPECT_LT(glm::distance(watch.crowd()[0].avatar.body.position,
                          museum.exhibits[0].viewing_point.position),
            0.02);
  EXPECT_LT(watch.quickest, 2.5);
}

TEST(AGuide, GoesOnAfterAPauseOfTheProgramThatLastedLongerThanItsRide) {
  Museum museum = house();
  for (Connection& connection : museum.connections)
    connection.closed = connection.kind != ConnectionKind::Lift;
  for (const std::size_t bodies : {1U, 2U}) {
    Watch watch(museum, bodies);
    for (std::size_t i = 0; i < bodies; ++i)
      watch.crowd().add(0, i == 0 ? museum.kiosk : at(3, 8, 0), 100, 1);
    const Exhibit& above = museum.exhibits[8];
    const auto boards = [&] { return watch.crowd()[0].boards; };
    for (int trip = 0; trip < 4; ++trip) {
      const bool goes_up = trip % 2 == 0;
      watch.crowd().send(0, goes_up ? above.floor : 0, goes_up ? above.viewing_point : museum.kiosk,
                         RouteKind::Shortest);
      for (int i = 0; i < 60 * 60 && !boards(); ++i) watch.step();
      ASSERT_TRUE(boards());
      for (int i = 0; i < trip; ++i) watch.step();  // asked, answered, getting on

      watch.step(30);

      EXPECT_TRUE(watch.run_until_arrived(0, 120)) << bodies << " bodies, trip " << trip;
    }
  }
}

TEST(AGuide, WhoseOnlyConnectionIsClosedSaysThatItIs) {
  Museum museum = house();
  museum.connections = {museum.connections[2]};
  museum.connections.front().closed = true;
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);

  watch.crowd().send(0, 1, museum.exhibits[8].viewing_point, RouteKind::Shortest);
  while (!watch.crowd()[0].route_summary) watch.step();

  EXPECT_EQ(watch.crowd()[0].route_summary->status, path::RouteStatus::NoRoute);
  EXPECT_EQ(watch.crowd()[0].route_summary->hindrance, interface::Hindrance::Lift);
  EXPECT_TRUE(watch.crowd()[0].has_arrived);
}

/// Why a guide finds no way up to the first floor, if so, and by what it goes there.
std::pair<std::optional<interface::Hindrance>, std::uint32_t> goes_up(
    std::vector<Connection> connections, const path::Permissions& permissions) {
  Museum museum = house();
  museum.connections = std::move(connections);
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);
  watch.crowd().send(0, 1, museum.exhibits[8].viewing_point, RouteKind::Shortest, permissions);
  while (!watch.crowd()[0].route_summary) watch.step();
  const Agent& agent = watch.crowd()[0];
  const auto& plan = agent.avatar.next ? agent.avatar.next : agent.avatar.plan;
  return {agent.route_summary->hindrance, plan && plan->then ? plan->then->connection : none};
}

TEST(AGuide, LeadsAWayWithoutStepsOrSaysWhyThereIsNone) {
  const Museum all = house();
  const Connection &stairs = all.connections[0], &lift = all.connections[2],
                   &escalator = all.connections[3];
  Connection broken = lift;
  broken.closed = true;

  EXPECT_EQ(goes_up({stairs, lift}, {}).second, 0U);
  EXPECT_EQ(goes_up({stairs, lift}, {.step_free = true}).second, 1U);
  EXPECT_EQ(goes_up({stairs}, {.step_free = true}).first, interface::Hindrance::Steps);
  EXPECT_EQ(goes_up({stairs, broken}, {.step_free = true}).first, interface::Hindrance::Lift);
  EXPECT_EQ(goes_up({escalator}, {}).second, 0U);
  EXPECT_EQ(goes_up({escalator}, {.no_escalators = true}).first, interface::Hindrance::Escalators);
  EXPECT_EQ(goes_up({escalator, stairs}, {.no_escalators = true}).second, 1U);
}

Place toilets(std::uint32_t floor, Vec2 standing) {
  return {.id = "",
          .kind = PlaceKind::WomensToilets,
          .floor = floor,
          .position = standing,
          .standing = standing,
          .title = {}};
}

TEST(AGuide, SentToTheNearestPlaceOfAKindGoesToTheOneThatIsNearestOnFoot) {
  Museum museum = house();
  // The straight line to the second is the shorter one, but it is a floor up.
  museum.places = {toilets(0, {15, 1}), toilets(1, {8, 4.5}), toilets(0, {1, 1})};
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);

  watch.crowd().seek(0, PlaceKind::Toilets, RouteKind::Shortest);

  ASSERT_TRUE(watch.run_until_arrived(0, 60));
  EXPECT_EQ(watch.crowd()[0].place, 0U);
  EXPECT_EQ(watch.crowd()[0].avatar.floor, 0U);
  EXPECT_LT(glm::distance(watch.crowd()[0].avatar.body.position, Vec2(15, 1)), 0.02);
}

TEST(AGuide, OnItsWayToTheNearestPlaceGoesToAnotherWhereTheWayThereIsClosed) {
  Museum museum = house();
  museum.connections = {museum.connections[2], museum.connections[0]};  // the lift, and stairs
  museum.places = {toilets(2, {14, 5}), toilets(1, {3, 8})};
  Watch watch(museum, 1);
  watch.crowd().add(0, at(14, 5, 0), 100, 1);
  watch.crowd().seek(0, PlaceKind::Toilets, RouteKind::Shortest);
  for (int i = 0; i < 60; ++i) watch.step();
  ASSERT_EQ(watch.crowd()[0].place, 0U);

  Closures closures;
  closures.doors.resize(3);
  closures.connections = {0};
  watch.planner().close(closures);
  watch.crowd().replan();

  ASSERT_TRUE(watch.run_until_arrived(0, 180));
  EXPECT_EQ(watch.crowd()[0].place, 1U);
  EXPECT_EQ(watch.crowd()[0].avatar.floor, 1U);
}

TEST(AGuide, SentToAPlaceThatNoWayLeadsToSaysWhy) {
  Museum museum = house();
  museum.connections = {museum.connections[2]};
  museum.connections.front().closed = true;
  museum.places = {toilets(2, {14, 5})};
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);

  watch.crowd().seek(0, PlaceKind::Toilets, RouteKind::Shortest);
  while (!watch.crowd()[0].route_summary) watch.step();

  EXPECT_EQ(watch.crowd()[0].route_summary->hindrance, interface::Hindrance::Lift);
  EXPECT_EQ(watch.crowd()[0].place, 0U) << "so that it can be said where";
  EXPECT_TRUE(watch.crowd()[0].has_arrived);
  watch.crowd().seek(0, PlaceKind::Cafe, RouteKind::Shortest);
  while (!watch.crowd()[0].route_summary) watch.step();
  EXPECT_EQ(watch.crowd()[0].route_summary->status, path::RouteStatus::NoRoute);
}

TEST(AGuide, SentToAPlaceThatOnlyAnEscalatorLeadsToSaysSo) {
  Museum museum = house();
  museum.connections = {museum.connections[3]};
  museum.places = {toilets(1, {14, 5})};
  Watch watch(museum, 1);
  watch.crowd().add(0, museum.kiosk, 100, 1);

  watch.crowd().seek(0, PlaceKind::Toilets, RouteKind::Shortest, {.no_escalators = true});
  while (!watch.crowd()[0].route_summary) watch.step();

  EXPECT_EQ(watch.crowd()[0].route_summary->status, path::RouteStatus::NoRoute);
  EXPECT_EQ(watch.crowd()[0].route_summary->hindrance, interface::Hindrance::Escalators);
}

/// One hall up the stairs from another, beside it and not above it.
Museum two_halls() {
  Museum museum = house();
  test::HallMaker below, above;
  below.room({0, 0}, {16, 10});
  above.room({-24, 0}, {-8, 10});
  museum.floors = {floor_of(below.plan, 0, museum), floor_of(above.plan, 1, museum)};
  museum.connections.resize(1);
  museum.connections[0].stops = {{0, at(0.6, 5, 180)}, {1, at(-8.6, 5, 0)}};
  return museum;
}

TEST(TwoGuides, WhoMeetAtAConnectionFromBothEndsBothGetOn) {
  const Museum museum = two_halls();
  Watch watch(museum, 2);
  watch.crowd().add(0, at(3, 3, 0), 100, 1);
  watch.crowd().add(1, at(-11, 7, 0), 100, 1);
  watch.step();
  watch.step();

  watch.crowd().send(0, 1, at(-16, 5, 0), RouteKind::Shortest);
  watch.crowd().send(1, 0, at(8, 5, 0), RouteKind::Shortest);

  EXPECT_TRUE(watch.run_until_arrived(0, 240));
  EXPECT_TRUE(watch.run_until_arrived(1, 240));
  EXPECT_EQ(watch.crowd()[0].avatar.floor, 1U);
  EXPECT_EQ(watch.crowd()[1].avatar.floor, 0U);
  EXPECT_EQ(watch.collisions, 0U);
  EXPECT_GE(watch.least_apart, 2 * museum.body_radius - 0.01);
}

TEST(EightGuides, SentUpTheSameStairsAtOnceAllGetThereAndBack) {
  NEEDS_SPEED();
  const Museum museum = two_halls();
  constexpr std::uint32_t guides = 8;
  Watch watch(museum, guides);
  for (std::uint32_t i = 0; i < guides; ++i) watch.crowd().add(0, at(4 + i, 3, 90), 100, 1);
  for (int i = 0; i < 30; ++i) watch.step();

  for (const std::uint32_t floor : {1U, 0U}) {
    for (std::uint32_t i = 0; i < guides; ++i)
      watch.crowd().send(i, floor, at((floor == 0 ? 3.0 : -20.0) + i, 7, 90), RouteKind::Shortest);
    for (std::uint32_t i = 0; i < guides; ++i) EXPECT_TRUE(watch.run_until_arrived(i, 600)) << i;
    std::printf("eight guides to floor %u: until %.0f s\n", floor, watch.crowd().clock());
  }
  EXPECT_EQ(watch.collisions, 0U);
  EXPECT_EQ(watch.rides, 2 * guides);
  EXPECT_GE(watch.least_apart, 2 * museum.body_radius - 0.01);
}

TEST(Strollers, ChangeFloorsAndMeetNobodyOnTheStairsInTheLiftOrOnAnyFloor) {
  NEEDS_SPEED();
  Museum museum = house();
  museum.ambient = {.count = 14, .entrances = {}, .look_least = 1, .look_most = 5};
  Watch watch(museum, 15);
  watch.crowd().add(0, museum.kiosk, 100, 1);
  Strollers strollers(museum);
  strollers.enter(watch.crowd());
  constexpr double seconds = test::is_sanitized ? 150 : 900;

  for (std::size_t way = 0; watch.crowd().clock() < seconds;) {
    strollers.step(watch.crowd());
    if (watch.crowd()[0].has_arrived) {
      const Exhibit& goal = museum.exhibits[7 * ++way % museum.exhibits.size()];
      watch.crowd().send(0, goal.floor, goal.viewing_point, static_cast<RouteKind>(way % 3));
    }
    watch.step();
  }

  std::printf("%.0f s of 15 bodies: %zu rides, %.3f m apart, clearance %.3f m, %.2f m/s\n", seconds,
              watch.rides, watch.least_apart, watch.least_clearance, watch.quickest);
  EXPECT_EQ(watch.collisions, 0U);
  EXPECT_GE(watch.least_apart, 2 * museum.body_radius - 0.01);
  EXPECT_GE(watch.least_clearance, museum.body_radius - 0.01);
  EXPECT_GT(watch.rides, static_cast<std::size_t>(seconds / 30));
  EXPECT_LT(watch.quickest, 2.5);
}

}  // namespace
}  // namespace docent::guide::floors_test
