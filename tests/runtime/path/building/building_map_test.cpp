#include "runtime/path/building/building_map.h"
#include "runtime/path/building/nearest_place.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "runtime/model/none.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::building_map_test {
namespace {

using path::BuildingQuery;
using path::BuildingStatus;
using path::BuildingWay;
using path::Metric;

constexpr double body = 0.25;

/// A museum of floors and connections, with its map.
class Building {
 public:
  void add_floor(const FloorPlan& plan) {
    museum_.floors.push_back(floor_of(plan, {0, body}));
    museum_.floors.back().plan.ordinal = static_cast<std::int32_t>(museum_.floors.size()) - 1;
  }
  Connection& add(ConnectionKind kind, std::vector<std::pair<std::uint32_t, Vec2>> stops) {
    Connection connection;
    connection.id = "c" + std::to_string(museum_.connections.size());
    connection.kind = kind;
    connection.step_free = kind == ConnectionKind::Lift || kind == ConnectionKind::Ramp;
    connection.wait_seconds = kind == ConnectionKind::Lift ? 20 : 0;
    connection.seconds_per_floor = kind == ConnectionKind::Lift ? 3 : 15;
    connection.metres_per_floor = kind == ConnectionKind::Lift ? 0 : 8;
    for (const auto& [floor, at] : stops) connection.stops.push_back({floor, {at, 0}});
    return museum_.connections.emplace_back(std::move(connection));
  }
  Museum& museum() { return museum_; }
  std::size_t floors() const { return museum_.floors.size(); }

  /// After all floors and connections.
  const path::BuildingMap& map() {
    if (!map_) {
      for (const Floor& floor : museum_.floors) floors_.push_back(path::make_floor_map(floor));
      map_ = std::make_unique<path::BuildingMap>(museum_, floors_);
    }
    return *map_;
  }
  bool has_room(std::uint32_t floor, Vec2 point) {
    return map().floor(floor).has_room(point, body);
  }
  path::Way along(std::uint32_t floor, path::RouteQuery query, Vec2 from, Vec2 to) {
    query.from = from;
    query.to = to;
    return path::route(map().floor(floor), query);
  }

 private:
  Museum museum_;
  std::vector<std::shared_ptr<const path::FloorMap>> floors_;
  std::unique_ptr<path::BuildingMap> map_;
};

BuildingQuery ask(std::uint32_t from_floor, Vec2 from, std::uint32_t to_floor, Vec2 to) {
  return {.way = {.from = from, .to = to, .radius = body},
          .from_floor = from_floor,
          .to_floor = to_floor};
}

/// The least cost of all sequences of rides, each connection taken at most twice, by trying them
/// all.
class BruteForce {
 public:
  BruteForce(Building& building, const BuildingQuery& query, Metric metric)
      : building_(building), query_(query), metric_(metric) {
    used_.assign(building.museum().connections.size(), 0);
    go_on(query.from_floor, query.way.from, 0);
  }
  double cost() const { return best_; }

 private:
  double metres(double length) const {
    return metric_ == Metric::Time ? length / strolling_pace : length;
  }
  bool may_take(const Connection& c) const {
    return !c.closed && (!query_.permissions.step_free || c.step_free) &&
           !(query_.permissions.no_escalators && c.kind == ConnectionKind::Escalator);
  }

  void go_on(std::uint32_t floor, Vec2 at, double cost) {
    if (cost >= best_) return;
    if (floor == query_.to_floor) {
      const path::Way last = building_.along(floor, query_.way, at, query_.way.to);
      if (last.status == path::RouteStatus::Ok) best_ = std::min(best_, cost + metres(last.length));
    }
    const std::vector<Connection>& connections = building_.museum().connections;
    for (std::size_t c = 0; c < connections.size(); ++c) {
      if (used_[c] == 2 || !may_take(connections[c])) continue;
      for (std::size_t from = 0; from < connections[c].stops.size(); ++from)
        if (connections[c].stops[from].floor == floor) take(c, from, floor, at, cost);
    }
  }

  void take(std::size_t c, std::size_t from, std::uint32_t floor, Vec2 at, double cost) {
    const Connection& connection = building_.museum().connections[c];
    const path::Way walk =
        building_.along(floor, query_.way, at, connection.stops[from].placement.position);
    if (walk.status != path::RouteStatus::Ok) return;
    ++used_[c];
    for (std::size_t to = 0; to < connection.stops.size(); ++to) {
      if (to == from || (connection.direction == ConnectionDirection::Up && to < from) ||
          (connection.direction == ConnectionDirection::Down && to > from))
        continue;
      const double apart = std::abs(static_cast<double>(connection.stops[to].floor) -
                                    static_cast<double>(connection.stops[from].floor));
      const double ride = metric_ == Metric::Time
                              ? connection.wait_seconds + apart * connection.seconds_per_floor
                              : apart * connection.metres_per_floor;
      go_on(connection.stops[to].floor, connection.stops[to].placement.position,
            cost + metres(walk.length) + ride);
    }
    --used_[c];
  }

  Building& building_;
  const BuildingQuery& query_;
  Metric metric_;
  std::vector<int> used_;
  double best_ = infinity;
};

/// Two to four halls, one above the other, joined at random; and two points with room for a body.
struct RandomBuilding {
  Building building;
  BuildingQuery query;
};

Connection random_connection(Building& building) {
  const auto kind = static_cast<ConnectionKind>(*rc::gen::inRange(0, 4));
  const auto floors = static_cast<std::uint32_t>(building.floors());
  const std::uint32_t left_out = *rc::gen::inRange<std::uint32_t>(0, 2 * floors);
  std::vector<std::pair<std::uint32_t, Vec2>> stops;
  for (std::uint32_t floor = 0; floor < floors; ++floor)
    if (floors == 2 || floor != left_out) stops.emplace_back(floor, random_point());
  Connection& made = building.add(kind, stops);
  made.direction = kind == ConnectionKind::Escalator
                       ? static_cast<ConnectionDirection>(*rc::gen::inRange(1, 3))
                       : ConnectionDirection::Both;
  made.closed = *rc::gen::inRange(0, 6) == 0;
  made.wait_seconds = *rc::gen::inRange(0, 40);
  made.seconds_per_floor = *rc::gen::inRange(1, 30);
  made.metres_per_floor = *rc::gen::inRange(0, 20);
  return made;
}

/// One of the first random points that have room for a body, if any has.
Vec2 standing_place(Building& building, std::uint32_t floor) {
  Vec2 point = random_point();
  for (int i = 0; i < 20 && !building.has_room(floor, point); ++i) point = random_point();
  RC_PRE(building.has_room(floor, point));
  return point;
}

void make(RandomBuilding& random) {
  const int floors = *rc::gen::inRange(2, 5), connections = *rc::gen::inRange(1, 4);
  for (int i = 0; i < floors; ++i) {
    const auto plan = random_hall();
    RC_PRE(plan.has_value());
    random.building.add_floor(*plan);
  }
  for (int i = 0; i < connections; ++i) random_connection(random.building);
  const auto any_floor = rc::gen::inRange<std::uint32_t>(0, static_cast<std::uint32_t>(floors));
  const std::uint32_t from = *any_floor, to = *any_floor;
  random.query =
      ask(from, standing_place(random.building, from), to, standing_place(random.building, to));
  random.query.permissions.step_free = *rc::gen::inRange(0, 4) == 0;
  random.query.permissions.no_escalators = *rc::gen::inRange(0, 4) == 0;
  random.query.metric = *rc::gen::element(Metric::Time, Metric::Length);
}

/// Does each leg begin where the one before ended, on the floor where it ended?
void expect_joined(Building& building, const BuildingQuery& query, const BuildingWay& way) {
  double length = 0, seconds = 0;
  std::uint32_t floor = query.from_floor;
  for (const path::Leg& leg : way.legs) {
    RC_ASSERT(leg.floor == floor);
    floor = leg.to_floor;
    length += leg.length;
    seconds += leg.seconds;
    if (leg.is_along_floor()) {
      RC_ASSERT(!leg.points.empty());
    } else {
      const auto& stops = building.museum().connections[leg.connection].stops;
      RC_ASSERT(std::ranges::find(stops, leg.to_floor, &ConnectionStop::floor) != stops.end());
    }
  }
  RC_ASSERT(floor == query.to_floor);
  RC_ASSERT(std::abs(length - way.length) < 1e-9);
  RC_ASSERT(std::abs(seconds - way.seconds) < 1e-9);
  RC_ASSERT(glm::distance(way.legs.front().points.front(), query.way.from) < 1e-9);
  RC_ASSERT(glm::distance(way.legs.back().points.back(), query.way.to) < 1e-9);
}

RC_GTEST_PROP(AWayThroughABuilding, CostsAsMuchAsTheBestOfAllSequencesOfConnections, ()) {
  RandomBuilding random;
  make(random);
  const BruteForce best(random.building, random.query, *random.query.metric);

  const BuildingWay way = random.building.map().route(random.query);

  RC_ASSERT((way.status == BuildingStatus::Ok) == (best.cost() < infinity));
  if (way.status != BuildingStatus::Ok) return;
  const double cost = random.query.metric == Metric::Time ? way.seconds : way.length;
  RC_ASSERT(std::abs(cost - best.cost()) < 1e-6);
  expect_joined(random.building, random.query, way);
}

RC_GTEST_PROP(AWayThroughABuilding, IsAsExactAlongTheMiddleOfTheRooms, ()) {
  RandomBuilding random;
  make(random);
  random.query.way.kind = RouteKind::Skeleton;
  const BruteForce best(random.building, random.query, *random.query.metric);

  const BuildingWay way = random.building.map().route(random.query);

  RC_ASSERT((way.status == BuildingStatus::Ok) == (best.cost() < infinity));
  const double cost = random.query.metric == Metric::Time ? way.seconds : way.length;
  if (way.status == BuildingStatus::Ok) RC_ASSERT(std::abs(cost - best.cost()) < 1e-6);
}

RC_GTEST_PROP(TheNearestPlace, IsTheOneThatTakesTheLeastTimeOfAll, ()) {
  RandomBuilding random;
  make(random);
  random.query.metric.reset();
  std::vector<Place> places;
  for (int i = *rc::gen::inRange(0, 6); i > 0; --i) {
    const auto floor = *rc::gen::inRange(0U, static_cast<std::uint32_t>(random.building.floors()));
    places.push_back({.kind = *rc::gen::element(PlaceKind::Toilets, PlaceKind::AccessibleToilets,
                                                PlaceKind::Seat),
                      .floor = floor,
                      .standing = standing_place(random.building, floor)});
  }
  double least = infinity;
  for (const Place& place : places) {
    if (place.kind == PlaceKind::Seat) continue;
    BuildingQuery query = random.query;
    query.metric = Metric::Time;
    query.to_floor = place.floor;
    query.way.to = place.standing;
    const BuildingWay way = random.building.map().route(query);
    if (way.status == BuildingStatus::Ok) least = std::min(least, way.seconds);
  }

  const path::NearestPlace nearest =
      path::nearest_place(random.building.map(), random.query, places, PlaceKind::Toilets);

  const bool has_any =
      std::ranges::any_of(places, [](const Place& place) { return place.kind != PlaceKind::Seat; });
  RC_ASSERT((nearest.place != none) == has_any);
  RC_ASSERT((nearest.way.status == BuildingStatus::Ok) == (least < infinity));
  if (least < infinity) RC_ASSERT(nearest.way.seconds == least);
}

/// Two halls of 12 by 8 m: stairs in the west, a lift in the east.
class TwoFloors : public ::testing::Test {
 protected:
  TwoFloors() {
    building_.add_floor(mended(drawn(rectangle({0, 0}, {12, 8}))));
    building_.add_floor(mended(drawn(rectangle({0, 0}, {12, 8}))));
    building_.add(ConnectionKind::Stairs, {{0, {1, 4}}, {1, {1, 4}}});
    building_.add(ConnectionKind::Lift, {{0, {11, 4}}, {1, {11, 4}}});
  }
  BuildingWay up(Vec2 from, Vec2 to, path::Permissions permissions = {},
                 std::optional<Metric> metric = {}) {
    BuildingQuery query = ask(0, from, 1, to);
    query.permissions = permissions;
    query.metric = metric;
    return building_.map().route(query);
  }
  std::string taken(const BuildingWay& way) {
    std::string ids;
    for (const path::Leg& leg : way.legs)
      if (!leg.is_along_floor()) ids += building_.museum().connections[leg.connection].id;
    return ids;
  }
  static constexpr std::uint32_t lift = 1;
  Building building_;
};

TEST_F(TwoFloors, AreJoinedByStairsBecauseTheLiftIsWaitedFor) {
  const BuildingWay way = up({6, 4}, {6, 4});

  ASSERT_EQ(way.status, BuildingStatus::Ok);
  EXPECT_EQ(taken(way), "c0");
  EXPECT_DOUBLE_EQ(way.length, 5 + 8 + 5);
  EXPECT_DOUBLE_EQ(way.seconds, 5 + 15 + 5);
  EXPECT_DOUBLE_EQ(way.clearance_min, 1);
  ASSERT_EQ(way.legs.size(), 3U);
}

TEST_F(TwoFloors, AreJoinedByTheLiftForWheels) {
  const BuildingWay way = up({6, 4}, {6, 4}, {.step_free = true});

  EXPECT_EQ(taken(way), "c1");
  EXPECT_DOUBLE_EQ(way.seconds, 5 + 23 + 5);
  EXPECT_DOUBLE_EQ(way.length, 10) << "nobody walks in a lift";
}

TEST_F(TwoFloors, TakeTheShorterWayWhereThatIsAskedFor) {
  EXPECT_EQ(taken(up({6, 4}, {6, 4}, {}, Metric::Length)), "c1");
}

TEST_F(TwoFloors, SayWhichLiftIsClosed) {
  building_.museum().connections[lift].closed = true;

  const BuildingWay way = up({6, 4}, {6, 4}, {.step_free = true});

  EXPECT_EQ(way.status, BuildingStatus::Closed);
  EXPECT_EQ(way.closed, std::vector<std::uint32_t>{lift});
  EXPECT_TRUE(way.legs.empty());
}

TEST_F(TwoFloors, SayThatThereAreOnlySteps) {
  building_.museum().connections[lift].step_free = false;

  EXPECT_EQ(up({6, 4}, {6, 4}, {.step_free = true}).status, BuildingStatus::NoStepFree);
}

TEST_F(TwoFloors, SayWhichEndIsBlocked) {
  EXPECT_EQ(up({0.1, 4}, {6, 4}).status, BuildingStatus::StartBlocked);
  EXPECT_EQ(up({6, 4}, {13, 4}).status, BuildingStatus::GoalBlocked);
}

TEST(AnEscalator, IsTakenTheWayItRuns) {
  Building building;
  for (int i = 0; i < 2; ++i) building.add_floor(mended(drawn(rectangle({0, 0}, {12, 8}))));
  building.add(ConnectionKind::Escalator, {{0, {1, 4}}, {1, {3, 4}}}).direction =
      ConnectionDirection::Up;
  const Vec2 at{6, 4};

  EXPECT_EQ(building.map().route(ask(0, at, 1, at)).status, BuildingStatus::Ok);
  EXPECT_EQ(building.map().route(ask(1, at, 0, at)).status, BuildingStatus::NoRoute);
  BuildingQuery without = ask(0, at, 1, at);
  without.permissions.no_escalators = true;
  EXPECT_EQ(building.map().route(without).status, BuildingStatus::NoRoute);
}

TEST(TwoWingsOfAFloor, AreJoinedByTheFloorBelow) {
  Building building;
  building.add_floor(mended(drawn(rectangle({0, 0}, {12, 8}))));
  // A wall right across the upper floor leaves two halls.
  import::ImportedPlan wings = drawn(rectangle({0, 0}, {5, 8}));
  wings.polygons.push_back(drawn(rectangle({7, 0}, {12, 8})).polygons.front());
  building.add_floor(mended(wings));
  building.add(ConnectionKind::Stairs, {{0, {1, 4}}, {1, {1, 4}}});
  building.add(ConnectionKind::Stairs, {{0, {11, 4}}, {1, {11, 4}}});

  const BuildingWay way = building.map().route(ask(1, {3, 4}, 1, {9, 4}));

  ASSERT_EQ(way.status, BuildingStatus::Ok);
  EXPECT_EQ(way.legs.size(), 5U);
  EXPECT_DOUBLE_EQ(way.length, 2 + 8 + 10 + 8 + 2);
}

TEST(ALiftOfFourFloors, IsWaitedForOnceAndCountsItsFloors) {
  Building building;
  std::vector<std::pair<std::uint32_t, Vec2>> stops;
  for (std::uint32_t i = 0; i < 4; ++i) {
    building.add_floor(mended(drawn(rectangle({0, 0}, {12, 8}))));
    stops.emplace_back(i, Vec2{6, 4});
  }
  building.add(ConnectionKind::Lift, stops);

  const BuildingWay way = building.map().route(ask(3, {6, 6}, 0, {6, 6}));

  EXPECT_DOUBLE_EQ(way.seconds, 2 + 20 + 3 * 3 + 2);
  EXPECT_EQ(way.legs.size(), 3U);
}

}  // namespace
}  // namespace docent::test::building_map_test
