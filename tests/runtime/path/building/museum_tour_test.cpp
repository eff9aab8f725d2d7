#include "runtime/path/building/museum_tour.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <vector>

#include "runtime/model/none.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::museum_tour_test {
namespace {

using path::BuildingPlace;
using path::BuildingStatus;
using path::Metric;

constexpr double body = 0.25;

/// A museum whose floors are halls of 12 by 8 m, one above the other, with its map.
class Halls {
 public:
  explicit Halls(std::size_t floors) {
    for (std::size_t i = 0; i < floors; ++i) add(mended(drawn(rectangle({0, 0}, {12, 8}))));
    museum_.kiosk = {{6, 1}, 0};
  }
  Halls() = default;

  void add(const FloorPlan& plan) {
    museum_.floors.push_back(floor_of(plan, {0, body}));
    museum_.floors.back().plan.ordinal = static_cast<std::int32_t>(museum_.floors.size()) - 1;
  }
  Connection& join(ConnectionKind kind, Vec2 low, Vec2 high, std::uint32_t floor = 0) {
    Connection one;
    one.id = "c" + std::to_string(museum_.connections.size());
    one.kind = kind;
    one.step_free = kind == ConnectionKind::Lift;
    one.wait_seconds = kind == ConnectionKind::Lift ? 20 : 0;
    one.seconds_per_floor = 15;
    one.metres_per_floor = 8;
    one.stops = {{floor, {low, 0}}, {floor + 1, {high, 0}}};
    return museum_.connections.emplace_back(std::move(one));
  }
  void exhibit(std::uint32_t floor, Vec2 view, double weight = 1, double looking = 10) {
    Exhibit exhibit;
    exhibit.id = "e" + std::to_string(museum_.exhibits.size());
    exhibit.floor = floor;
    exhibit.viewing_point.position = view;
    exhibit.weight = weight;
    exhibit.looking_seconds = looking;
    museum_.exhibits.push_back(exhibit);
  }
  Museum& museum() { return museum_; }
  const path::BuildingMap& map() {
    if (map_) return *map_;
    std::vector<std::shared_ptr<const path::FloorMap>> floors;
    for (const Floor& floor : museum_.floors) floors.push_back(path::make_floor_map(floor));
    map_ = std::make_unique<path::BuildingMap>(museum_, std::move(floors));
    return *map_;
  }
  path::TourWish wish() const {
    path::TourWish wish = path::tour_from_kiosk(museum_);
    wish.way.radius = body;
    return wish;
  }
  path::MuseumTour shortest(const std::vector<std::uint32_t>& exhibits,
                            const path::ExhibitEnds& ends = {}, bool step_free = false) {
    path::TourWish asked = wish();
    asked.permissions.step_free = step_free;
    return path::shortest_tour(museum_, map(), exhibits, ends, asked);
  }

 private:
  Museum museum_;
  std::unique_ptr<path::BuildingMap> map_;
};

RC_GTEST_PROP(CostsBetweenPlaces, AreThoseOfTheWaysBetweenThem, ()) {
  Halls halls;
  const int floors = *rc::gen::inRange(1, 4);
  for (int i = 0; i < floors; ++i) {
    const auto plan = random_hall();
    RC_PRE(plan.has_value());
    halls.add(*plan);
  }
  for (int i = 0; i + 1 < floors; ++i)
    for (int n = *rc::gen::inRange(0, 3); n > 0; --n) {
      const auto kind = static_cast<ConnectionKind>(*rc::gen::inRange(0, 3));
      Connection& made =
          halls.join(kind, random_point(), random_point(), static_cast<std::uint32_t>(i));
      if (kind == ConnectionKind::Escalator)
        made.direction = static_cast<ConnectionDirection>(*rc::gen::inRange(1, 3));
      made.closed = *rc::gen::inRange(0, 5) == 0;
    }
  path::BuildingQuery kind{.way = {.radius = body, .tell_clearance = false}};
  kind.metric = *rc::gen::element(Metric::Time, Metric::Length);
  kind.permissions.step_free = *rc::gen::inRange(0, 3) == 0;
  std::vector<BuildingPlace> places;
  for (int i = 0; i < 6; ++i)
    places.push_back({static_cast<std::uint32_t>(*rc::gen::inRange(0, floors)), random_point()});

  const path::TourCosts costs = path::place_costs(halls.map(), kind, places);

  for (std::size_t a = 0; a < places.size(); ++a)
    for (std::size_t b = 0; b < places.size(); ++b) {
      if (a == b) continue;
      path::BuildingQuery query = kind;
      query.way.from = places[a].position;
      query.way.to = places[b].position;
      query.from_floor = places[a].floor;
      query.to_floor = places[b].floor;
      const path::BuildingWay way = halls.map().route(query);
      const double cost = kind.metric == Metric::Time ? way.seconds : way.length;
      const bool is_way = way.status == BuildingStatus::Ok;
      RC_ASSERT(is_way == (costs.at(a, b) < infinity));
      if (is_way) RC_ASSERT(std::abs(cost - costs.at(a, b)) < 1e-6);
    }
}

TEST(ATour, GoesOnceUpAndSeesAFloorBeforeItGoesOn) {
  Halls halls(2);
  halls.join(ConnectionKind::Stairs, {1, 4}, {1, 4});
  halls.exhibit(1, {10, 7});
  halls.exhibit(0, {10, 2});
  halls.exhibit(1, {3, 2});
  halls.exhibit(0, {3, 6});

  const path::MuseumTour tour = halls.shortest({0, 1, 2, 3});

  EXPECT_FALSE(tour.why_not.has_value());
  EXPECT_TRUE(tour.optimal);
  EXPECT_EQ(tour.exhibits, (std::vector<std::uint32_t>{1, 3, 2, 0}));
  EXPECT_DOUBLE_EQ(tour.looking_seconds, 40);
  EXPECT_DOUBLE_EQ(tour.seconds(), tour.walk_seconds + 40);
  EXPECT_NEAR(tour.length - 8, tour.walk_seconds - 15, 1e-9) << "stairs: 8 m in 15 s";
}

TEST(ATour, BeginsAndEndsWhereItShould) {
  Halls halls(1);
  for (const double x : {2.0, 4.0, 8.0, 10.0}) halls.exhibit(0, {x, 4});

  const path::MuseumTour tour = halls.shortest({0, 1, 2, 3}, {.first = 3, .last = 2});

  EXPECT_EQ(tour.exhibits.front(), 3U);
  EXPECT_EQ(tour.exhibits.back(), 2U);
}

TEST(ATour, SaysThatThereAreOnlySteps) {
  Halls halls(2);
  halls.join(ConnectionKind::Stairs, {1, 4}, {1, 4});
  halls.exhibit(0, {3, 6});
  halls.exhibit(1, {3, 6});

  const path::MuseumTour tour = halls.shortest({0, 1}, {}, true);

  EXPECT_EQ(tour.why_not, BuildingStatus::NoStepFree);
  EXPECT_EQ(tour.unreached, std::vector<std::uint32_t>{1});
}

TEST(ATour, HasNoOrderBetweenTwoTowersThatNobodyComesDownFrom) {
  Halls halls(3);
  halls.join(ConnectionKind::Escalator, {1, 4}, {1, 4}).direction = ConnectionDirection::Up;
  Connection& other = halls.join(ConnectionKind::Escalator, {11, 4}, {11, 4});
  other.direction = ConnectionDirection::Up;
  other.stops[1].floor = 2;
  halls.exhibit(1, {3, 6});
  halls.exhibit(2, {3, 6});

  const path::MuseumTour tour = halls.shortest({0, 1});

  EXPECT_EQ(tour.why_not, BuildingStatus::NoRoute);
  EXPECT_TRUE(tour.unreached.empty()) << "each alone can be reached";
}

TEST(TheBestTour, IsWhatThereIsTimeForAndNeverLate) {
  Halls halls(2);
  halls.join(ConnectionKind::Lift, {11, 4}, {11, 4});
  for (const double x : {2.0, 4.0, 8.0, 10.0}) halls.exhibit(0, {x, 6}, 1, 20);
  halls.exhibit(1, {6, 4}, 9, 20);

  for (const double seconds : {0.0, 20.0, 30.0, 60.0, 80.0, 120.0, 200.0, 600.0}) {
    const path::MuseumTour tour =
        path::best_tour(halls.museum(), halls.map(), seconds, halls.wish());
    EXPECT_TRUE(tour.optimal);
    EXPECT_LE(tour.seconds(), seconds);
    EXPECT_EQ(tour.weight >= 9, seconds >= 80) << seconds;
  }
}

TEST(TheBestTour, ChoosesAmongAThousandExhibits) {
  Halls halls(1);
  for (int i = 0; i < 1000; ++i)
    halls.exhibit(0, {1 + (i % 100) * 0.1, 1 + (i / 100) * 0.6}, 1, 10);

  const path::MuseumTour tour = path::best_tour(halls.museum(), halls.map(), 100, halls.wish());

  EXPECT_FALSE(tour.optimal) << "not all were looked at";
  EXPECT_GE(tour.exhibits.size(), 8U);
  EXPECT_LE(tour.seconds(), 100);
}

}  // namespace
}  // namespace docent::test::museum_tour_test
