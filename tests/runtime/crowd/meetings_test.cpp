#include "runtime/crowd/meetings.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "runtime/model/none.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/motion/allocation_count.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/reference_data.h"

namespace docent::test::meetings_test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::Field;
using testing::IsEmpty;
using testing::Matcher;

/// A floor that stays where it is, with its map.
struct Mapped {
  explicit Mapped(const FloorPlan& plan)
      : floor(floor_of(plan)), map(path::make_floor_map(floor)) {}
  explicit Mapped(const import::ImportedPlan& plan) : Mapped(mended(plan)) {}
  Mapped(const Mapped&) = delete;
  Mapped& operator=(const Mapped&) = delete;
  Floor floor;
  std::shared_ptr<const path::FloorMap> map;
};

/// A hall of 12 by 8 m, divided by panels 1 cm thick and 3 m long, in pairs with a slit of 0.2 m
/// between them: regions thinner than anybody.
import::ImportedPlan hall_of_thin_panels() {
  std::vector<Points> panels;
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 2; ++row) {
      const Vec2 low{1.5 + 2.4 * column, 0.5 + 3.3 * row};
      panels.push_back(rectangle(low, low + Vec2{0.01, 3}));
      panels.push_back(rectangle(low + Vec2{0.21, 0}, low + Vec2{0.22, 3}));
      if (column % 2 == 0) panels.push_back(rectangle(low + Vec2{0.5, 1}, low + Vec2{2, 1.005}));
    }
  return drawn(rectangle({0, 0}, {12, 8}), panels);
}

Matcher<const crowd::Meeting&> Pair(std::uint32_t a, std::uint32_t b, double time) {
  return AllOf(Field(&crowd::Meeting::a, a), Field(&crowd::Meeting::b, b),
               Field(&crowd::Meeting::time, testing::DoubleNear(time, 1e-9)));
}

std::vector<crowd::Meeting> meetings_of(const Mapped& mapped,
                                        const std::vector<crowd::Body>& bodies, double horizon) {
  crowd::Meetings meetings(*mapped.map, bodies.size());
  meetings.update(bodies);
  const auto found = meetings.find(horizon);
  return {found.begin(), found.end()};
}

// --- What a meeting is.

TEST(Meetings, AreOfThoseWhoTouchNowOrWithinTheHorizon) {
  const Mapped hall(drawn(rectangle({0, 0}, {40, 8})));
  const std::vector<crowd::Body> bodies{{{2, 4}, {1, 0}, 0.25},  {{6.5, 4}, {-1, 0}, 0.25},
                                        {{20, 4}, {0, 0}, 0.25}, {{20.5, 4}, {0, 0}, 0.25},
                                        {{30, 4}, {0, 1}, 0.25}, {{30, 4}, {0, 1}, 0.25},
                                        {{35, 4}, {0, 0}, 0.25}, {{35.501, 4}, {0, 0}, 0.25}};

  EXPECT_THAT(meetings_of(hall, bodies, 2),
              ElementsAre(Pair(0, 1, 2), Pair(2, 3, 0), Pair(4, 5, 0)));
  EXPECT_THAT(meetings_of(hall, bodies, 1.99), ElementsAre(Pair(2, 3, 0), Pair(4, 5, 0)));
}

TEST(Meetings, AreNotOfThoseWhomAWallKeepsApart) {
  const Mapped rooms(two_rooms(1));  // The wall is at x = 4 to 4.2, the door at y = 1.5 to 2.5.
  const crowd::Body left{{3.8, 3.5}, {0, 0}, 0.25}, right{{4.4, 3.5}, {0, 0}, 0.4};
  const crowd::Body to_the_right{{2, 3.5}, {1, 0}, 0.25}, to_the_left{{6, 3.5}, {-1, 0}, 0.25};
  const crowd::Body through_the_door{{2, 2}, {1, 0}, 0.25}, against_it{{6, 2}, {-1, 0}, 0.25};

  EXPECT_THAT(meetings_of(rooms, {left, right}, 5), IsEmpty()) << "they overlap behind the wall";
  EXPECT_THAT(meetings_of(rooms, {to_the_right, right}, 5), IsEmpty());
  EXPECT_THAT(meetings_of(rooms, {to_the_right, to_the_left}, 5), IsEmpty());
  EXPECT_THAT(meetings_of(rooms, {through_the_door, against_it}, 5), ElementsAre(Pair(0, 1, 1.75)));
}

TEST(Meetings, CountFromWhereTheWallBetweenEnds) {
  const Mapped hall(drawn(rectangle({0, 0}, {12, 8}), {rectangle({2, 4}, {6, 4.01})}));
  // Side by side along the panel, and past its end at t = 2.
  const std::vector<crowd::Body> bodies{{{4, 3.8}, {1, 0}, 0.25}, {{4, 4.2}, {1, 0}, 0.25}};

  EXPECT_THAT(meetings_of(hall, bodies, 3), ElementsAre(Pair(0, 1, 2)));
  EXPECT_THAT(meetings_of(hall, bodies, 1.9), IsEmpty());
}

TEST(Meetings, ReachOverRegionsThinnerThanTheBodies) {
  const Mapped hall(hall_of_thin_panels());
  // Below the panels, with the regions of their ends and of the slit between the two.
  const std::vector<crowd::Body> bodies{{{1.4, 0.3}, {0, 0}, 0.25}, {{1.85, 0.3}, {0, 0}, 0.25}};

  EXPECT_THAT(meetings_of(hall, bodies, 0), ElementsAre(Pair(0, 1, 0)));
}

TEST(Meetings, AreDefinedForBodiesThatShouldNotBe) {
  const Mapped rooms(two_rooms(1));
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const crowd::Body in_the_wall{{4.1, 3.5}, {0, 0}, 0.25}, beside_it{{3.8, 3.5}, {0, 0}, 0.25};
  const std::vector<crowd::Body> bodies{in_the_wall,
                                        beside_it,
                                        {{nan, 1}, {0, 0}, 0.25},
                                        {{1, 1}, {infinity, 0}, 0.25},
                                        {{1, 1}, {0, 0}, -1},
                                        {{-1e12, 0}, {0, 0}, 1}};

  EXPECT_THAT(meetings_of(rooms, bodies, 1), ElementsAre(Pair(0, 1, 0)));
  EXPECT_THAT(meetings_of(rooms, bodies, nan), ElementsAre(Pair(0, 1, 0)));
  EXPECT_THAT(meetings_of(rooms, bodies, -1), ElementsAre(Pair(0, 1, 0)));
  EXPECT_THAT(meetings_of(rooms, bodies, infinity), ElementsAre(Pair(0, 1, 0)));
  EXPECT_THAT(meetings_of(rooms, {}, 1), IsEmpty());
}

// --- Situations.

/// Bodies where it is hard: on walls and in corners, on Voronoi vertices and edges, on the borders
/// of cells, on each other, behind each other's walls, off the floor; still, walking, running,
/// flying.
class Situations {
 public:
  Situations(const Mapped& mapped, const crowd::WalkableCells& cells, std::uint64_t seed)
      : mapped_(mapped), cells_(cells), random_(seed) {
    for (const Vec2 v : plan().vertex) low_ = glm::min(low_, v), high_ = glm::max(high_, v);
  }

  std::vector<crowd::Body> any(std::size_t count) {
    std::vector<crowd::Body> bodies;
    for (std::size_t i = 0; i < count; ++i) {
      crowd::Body body{
          .position = any_place(bodies), .velocity = any_velocity(), .radius = any_radius()};
      if (pick(4) == 0 && !bodies.empty())  // Right at somebody.
        body.velocity = between(0, 2) * (bodies[pick(bodies.size())].position - body.position);
      bodies.push_back(body);
    }
    return bodies;
  }
  /// The next step: on they go, and some turn, stop, jump or grow.
  void step(std::vector<crowd::Body>& bodies) {
    for (crowd::Body& body : bodies) {
      body.position += body.velocity / 60.0;
      switch (pick(40)) {
        case 0:
          body.velocity = any_velocity();
          break;
        case 1:
          body.position = any_place(bodies);
          break;
        case 2:
          body.position += Vec2{between(-0.3, 0.3), between(-0.3, 0.3)};
          break;
        case 3:
          body.radius = any_radius();
          break;
        default:
          break;
      }
    }
  }
  double any_horizon() {
    constexpr std::array horizons{0.0, 0.5, 1.0, 2.0, 8.0};
    return horizons[pick(horizons.size())];
  }
  std::size_t pick(std::size_t count) { return random_() % count; }

 private:
  const FloorPlan& plan() const { return mapped_.floor.plan; }
  double between(double a, double b) { return std::uniform_real_distribution(a, b)(random_); }

  Vec2 anywhere() {
    const double x = between(low_.x, high_.x);
    return {x, between(low_.y, high_.y)};
  }
  Vec2 inside() {
    for (int tries = 0; tries < 50; ++tries)
      if (const Vec2 point = anywhere(); mapped_.map->is_inside(point)) return point;
    return anywhere();
  }
  Vec2 any_place(const std::vector<crowd::Body>& others) {
    const VoronoiDiagram& diagram = mapped_.floor.diagram;
    const auto wall = static_cast<std::uint32_t>(pick(plan().vertex.size()));
    const Vec2 a = wall_start(plan(), wall), b = wall_end(plan(), wall);
    switch (pick(12)) {
      case 0:
        return a;
      case 1:
        return glm::mix(a, b, between(0, 1));
      case 2:
        return glm::mix(a, b, between(0, 1)) + 0.25 * glm::normalize(left_of(b - a));
      case 3:
        return diagram.vertex[pick(diagram.vertex.size())];
      case 4: {
        const VoronoiEdge& edge = diagram.edge[pick(diagram.edge.size())];
        return glm::mix(diagram.vertex[edge.from], diagram.vertex[edge.to], between(0, 1));
      }
      case 5: {
        const Vec2 centre = cells_.centre_of(static_cast<std::uint32_t>(pick(cells_.count())));
        const double half = cells_.size() / 2;
        return centre + Vec2{pick(2) == 0 ? half : -half, pick(2) == 0 ? half : between(-1, 1)};
      }
      case 6:
        return others.empty() ? inside() : others[pick(others.size())].position;
      case 7:
        return others.empty() ? inside()
                              : others[pick(others.size())].position +
                                    Vec2{between(-0.6, 0.6), between(-0.6, 0.6)};
      case 8:
        return pick(4) == 0 ? anywhere() * 1.2 : inside();
      default:
        return inside();
    }
  }
  Vec2 any_velocity() {
    const auto towards_anywhere = [&](double speed) {
      const double angle = between(0, 6.3);
      return speed * Vec2{std::cos(angle), std::sin(angle)};
    };
    const auto wall = static_cast<std::uint32_t>(pick(plan().vertex.size()));
    switch (pick(8)) {
      case 0:
        return {0, 0};
      case 1:
        return glm::normalize(wall_end(plan(), wall) - wall_start(plan(), wall));
      case 2:
        return towards_anywhere(between(0, 20));
      case 3:
        return pick(10) == 0 ? towards_anywhere(1000) : Vec2{1, 0};
      default:
        return towards_anywhere(between(0.5, 1.5));
    }
  }
  double any_radius() {
    constexpr std::array radii{0.0, 0.25, 0.25, 0.25, 0.3, 0.5, 1.5};
    return radii[pick(radii.size())];
  }

  const Mapped& mapped_;
  const crowd::WalkableCells& cells_;
  std::mt19937_64 random_;
  Vec2 low_{0, 0}, high_{0, 0};
};

std::vector<crowd::Meeting> by_brute_force(const crowd::WalkableCells& cells,
                                           const std::vector<crowd::Body>& bodies, double horizon) {
  std::vector<crowd::Meeting> found;
  for (std::uint32_t a = 0; a < bodies.size(); ++a)
    for (std::uint32_t b = a + 1; b < bodies.size(); ++b)
      if (const auto time = crowd::time_of_impact(cells, bodies[a], bodies[b], horizon))
        found.push_back({a, b, *time});
  return found;
}

std::string text(std::span<const crowd::Meeting> meetings) {
  std::string result;
  for (const crowd::Meeting& m : meetings)
    result +=
        std::to_string(m.a) + "-" + std::to_string(m.b) + " at " + std::to_string(m.time) + ", ";
  return result;
}

/// To the last bit.
bool are_same(std::span<const crowd::Meeting> left, std::span<const crowd::Meeting> right) {
  return std::ranges::equal(left, right, [](const crowd::Meeting& a, const crowd::Meeting& b) {
    return a.a == b.a && a.b == b.b && a.time == b.time;
  });
}

/// Is every body in the region that is nearest to it?
void check_regions(const Mapped& mapped, const crowd::Meetings& meetings,
                   const std::vector<crowd::Body>& bodies) {
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Vec2 at = bodies[i].position;
    const std::uint32_t region = meetings.region_of(i);
    EXPECT_EQ(region != none, mapped.map->is_inside(at));
    if (region == none) continue;
    const Site site = mapped.floor.diagram.site[region];
    EXPECT_NEAR(distance_to_site(mapped.floor.plan, site, at), mapped.map->clearance_at(at), 1e-9);
  }
}

/// Goes through situations on one floor, ten steps of each. One set of meetings is kept up through
/// all; now and then another one begins from nothing. How many pairs met.
std::size_t check_situations(const Mapped& mapped, std::uint64_t seed, int situations,
                             std::size_t count = 10) {
  crowd::Meetings kept(*mapped.map, count);
  Situations maker(mapped, kept.cells(), seed);
  std::vector<crowd::Body> bodies;
  std::size_t met = 0;
  for (int i = 0; i < situations && !testing::Test::HasFailure(); ++i) {
    if (i % 10 == 0)
      bodies = maker.any(count);
    else
      maker.step(bodies);
    const double horizon = maker.any_horizon();
    const auto expected = by_brute_force(kept.cells(), bodies, horizon);
    kept.update(bodies);
    const auto found = kept.find(horizon);
    EXPECT_TRUE(are_same(found, expected)) << "seed " << seed << ", situation " << i << ": "
                                           << text(found) << "instead of " << text(expected);
    met += found.size();
    if (i % 7 == 0) check_regions(mapped, kept, bodies);
    if (i % 97 == 0) {
      crowd::Meetings fresh(*mapped.map, count);
      fresh.update(bodies);
      EXPECT_TRUE(are_same(fresh.find(horizon), expected)) << "from nothing, situation " << i;
    }
  }
  return met;
}

TEST(Meetings, AreWhatBruteForceFindsIn100000Situations) {
  std::size_t met = 0;
  met += check_situations(Mapped(hall_of_thin_panels()), 1, 25'000);
  met += check_situations(Mapped(two_rooms(0.9)), 2, 20'000);
  met += check_situations(Mapped(hall_with_a_box()), 3, 20'000);
  met += check_situations(Mapped(drawn(rectangle({0, 0}, {3, 3}))), 4, 5'000);
  met += check_situations(Mapped(drawn(regular_polygon({0, 0}, 5, 40))), 5, 10'000);
  met += check_situations(Mapped(drawn(rectangle({0, 0}, {60, 0.6}))), 6, 20'000);
  met += check_situations(Mapped(hall_of_thin_panels()), 7, 500, 80);

  EXPECT_GT(met, 100'000U) << "the situations are tame";
}

RC_GTEST_PROP(Meetings, AreWhatBruteForceFindsInAnyHall, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const auto seed = *rc::gen::arbitrary<std::uint64_t>();

  check_situations(Mapped(*plan), seed, 250);

  RC_ASSERT(!testing::Test::HasFailure());
}

TEST(Meetings, AreWhatBruteForceFindsOnTheReferenceMaps) {
  const auto folder = reference_data() / "floorplans" / "reference" / "maps";
  if (!std::filesystem::exists(folder)) GTEST_SKIP() << "needs the reference data";
  for (const char* name : {"museum-s1", "museum-m1", "westport-f2"}) {
    const Polymap polymap = read_polymap(folder / (std::string(name) + ".json"));
    check_situations(Mapped(polymap.plan), 8, 300, 60);
  }
}

/// The definition again, at one moment, with nothing but `can_see`.
bool meet_at(const path::FloorMap& map, const crowd::Body& a, const crowd::Body& b, double time,
             double slack) {
  const Vec2 a_then = a.position + time * a.velocity, b_then = b.position + time * b.velocity;
  return glm::distance(a_then, b_then) <= a.radius + b.radius + slack &&
         path::can_see(map, a.position, a_then) && path::can_see(map, b.position, b_then) &&
         path::can_see(map, a_then, b_then);
}

TEST(Meetings, AreAtTheFirstMomentThatAWatcherSees) {
  const Mapped mapped(hall_of_thin_panels());
  const crowd::WalkableCells cells(*mapped.map, 2);
  Situations maker(mapped, cells, 11);
  constexpr double horizon = 2;
  constexpr int moments = 300;
  int met = 0, late = 0;
  for (int i = 0; i < 6'000; ++i) {
    const auto bodies = maker.any(2);
    const crowd::Body &a = bodies[0], &b = bodies[1];
    if (!mapped.map->is_inside(a.position) || !mapped.map->is_inside(b.position)) continue;
    const auto time = crowd::time_of_impact(cells, a, b, horizon);

    for (int k = 0; k <= moments; ++k) {
      const double at = horizon * k / moments;
      if (!meet_at(*mapped.map, a, b, at, -1e-9)) continue;
      ASSERT_TRUE(time.has_value()) << "situation " << i << " at " << at;
      ASSERT_LE(*time, at + 1e-9) << "situation " << i;
      break;
    }
    if (!time) continue;
    ++met;
    if (*time > crowd::contact_of_circles(a, b, horizon)->first + 1e-9) ++late;
    const bool is_seen = std::ranges::any_of(std::array{0.0, 1e-12, 1e-9, 1e-7}, [&](double later) {
      return meet_at(*mapped.map, a, b, *time + later, 1e-6);
    });
    EXPECT_TRUE(is_seen) << "situation " << i << " at " << *time;
  }
  EXPECT_GT(met, 1'000);
  EXPECT_GT(late, 10) << "walls that end were not tried";
}

TEST(Meetings, AllocateNothingOnceMade) {
  const Mapped mapped(hall_of_thin_panels());
  crowd::Meetings meetings(*mapped.map, 20);
  Situations maker(mapped, meetings.cells(), 12);
  std::vector<crowd::Body> bodies = maker.any(20);
  std::vector<std::vector<crowd::Body>> steps;
  for (int i = 0; i < 600; ++i) {
    maker.step(bodies);
    steps.push_back(bodies);
  }

  long during = 0;
  for (const auto& step : steps) {
    const long before = allocation_count();
    meetings.update(step);
    const std::size_t found = meetings.find(1).size();
    if (found <= 4 * step.size()) during += allocation_count() - before;
  }
  EXPECT_EQ(during, 0);
}

}  // namespace
}  // namespace docent::test::meetings_test
