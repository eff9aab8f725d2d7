#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <random>

#include "content/content_error.h"
#include "runtime/model/none.h"
#include "tests/content/floor/sharp_plan.h"
#include "tests/runtime/path/brute_force_ways.h"
#include "tests/runtime/path/floors.h"

namespace docent::test::sharp_tips_test {
namespace {

constexpr double exact = 1e-9;  // Metres.
/// Of ways that differ by less either may be answered: labels round two costs of a way to the
/// nearest unit, and two more are rounded down. Metres.
double undecided_on(const Floor& floor) {
  double unit = 0;
  for (const HubLabels& labels : floor.hub_labels) unit = std::max(unit, labels.unit);
  return 4 * unit;
}

/// Where thin wedges stand, a way round the wrong end of one is up to several times too long.
import::ImportedPlan hall_of_wedges() {
  return drawn(rectangle({0, 0}, {8, 8}), {{{5.8103, 1.6056}, {6.3064, 2.4301}, {6.3031, 2.4321}},
                                           {{6.932, 2.7846}, {5.802, 3.9622}, {5.7672, 3.9278}},
                                           {{7.2952, 6.1874}, {6.0106, 7.038}, {6.0072, 7.0329}},
                                           {{0.6837, 5.4577}, {0.497, 2.255}, {0.5291, 2.2533}},
                                           {{1.1023, 7.3516}, {2.7298, 6.6166}, {2.7371, 6.6329}},
                                           {{6.9262, 3.5884}, {7.3025, 5.1117}, {7.2979, 5.1128}},
                                           {{1.6469, 3.0099}, {5.7025, 2.25}, {5.7047, 2.2622}},
                                           {{5.3825, 0.707}, {2.9457, 0.8073}, {2.9448, 0.7829}},
                                           {{3.0986, 2.2863}, {2.5195, 0.8505}, {2.5628, 0.8338}}});
}

TEST(SharpTips, AreWalkedRoundOnTheShorterSide) {
  const Floor floor = floor_of(hall_of_wedges(), {0, 0.25});
  const auto map = path::make_floor_map(floor);

  const path::Way way = path::route(
      *map, {.kind = RouteKind::Shortest, .from = {7.2, 5.5}, .to = {6.8, 6.6}, .radius = 0});

  const Vec2 tip{7.2952, 6.1874};
  EXPECT_NEAR(way.length, glm::distance({7.2, 5.5}, tip) + glm::distance(tip, {6.8, 6.6}), exact);
}

/// The mended plan of some spikes; none where they fill the hall or touch in points.
std::optional<FloorPlan> mended_hall(const std::vector<Spike>& spikes) {
  try {
    FloorPlan plan = mended(hall_with_spikes(spikes));
    for (std::size_t i = 0; i < plan.vertex.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        if (plan.vertex[i] == plan.vertex[j]) return {};
    return plan;
  } catch (const content::ContentError&) {
    return {};
  }
}

/// Anywhere, or a little way from some corner, or from the circle on which a disc rolls round it.
Vec2 place_in(const FloorPlan& plan, double radius, std::mt19937& random) {
  std::uniform_real_distribution<double> anywhere(0, 8), turn(0, 6.2831853), share(0, 1);
  const double kind = share(random), aside = share(random);
  if (kind < 0.3) return {anywhere(random), anywhere(random)};
  const Vec2 corner = plan.vertex[random() % plan.vertex.size()];
  const double angle = turn(random);
  const double far =
      kind < 0.6 ? 1.5 * std::pow(1e-3, aside) : radius + 2e-7 + 0.1 * std::pow(1e-6, aside);
  return corner + far * Vec2{std::cos(angle), std::sin(angle)};
}

/// Room for a disc, and not by a hair.
bool has_room(const FloorPlan& plan, Vec2 place, double radius) {
  return is_inside(plan, place) && distance_to_nearest_wall(plan, place) > radius + 1e-7;
}

path::Way shortest(const path::FloorMap& map, double radius, Vec2 from, Vec2 to) {
  return path::route(map, {.kind = RouteKind::Shortest, .from = from, .to = to, .radius = radius});
}

void check_way(const Floor& floor, const path::FloorMap& map, const BruteForceWays& brute,
               double radius, Vec2 from, Vec2 to) {
  const FloorPlan& plan = floor.plan;
  const double undecided = undecided_on(floor);
  const path::Way way = shortest(map, radius, from, to);
  const double expected = brute.length(from, to);
  const bool is_right = way.status == path::RouteStatus::Ok
                            ? std::abs(way.length - expected) < exact + undecided
                            : !std::isfinite(expected);
  if (is_right) return;
  // What misses a wall by the tolerance may touch it or not.
  const double loose = BruteForceWays(plan, radius, 1.5e-9).length(from, to);
  const double strict = BruteForceWays(plan, radius, 1e-11).length(from, to);
  const double length = way.status == path::RouteStatus::Ok ? way.length : infinity;
  RC_LOG(fmt::format("radius {:.17g} from {:.17g},{:.17g} to {:.17g},{:.17g}: {:.17g} is {:.17g}",
                     radius, from.x, from.y, to.x, to.y, length, expected));
  RC_ASSERT(length > loose - exact);
  RC_ASSERT(length < strict + exact + undecided || length == strict);
}

void check_ways(const Floor& floor, const path::FloorMap& map, double radius, int queries,
                std::mt19937& random) {
  const FloorPlan& plan = floor.plan;
  const BruteForceWays brute(plan, radius);
  for (int q = 0; q < queries; ++q) {
    const Vec2 from = place_in(plan, radius, random), to = place_in(plan, radius, random);
    if (has_room(plan, from, radius) && has_room(plan, to, radius))
      check_way(floor, map, brute, radius, from, to);
  }
}

/// Between two ends to which ways set out differently there is one where two ways are as long: asks
/// for ends about it, where a way that is a hair too short or too long shows.
void check_ways_near_ties(const Floor& floor, const path::FloorMap& map, double radius, int queries,
                          std::mt19937& random) {
  const FloorPlan& plan = floor.plan;
  const BruteForceWays brute(plan, radius);
  for (int q = 0; q < queries; ++q) {
    const Vec2 from = place_in(plan, radius, random);
    Vec2 to = place_in(plan, radius, random), other = place_in(plan, radius, random);
    if (!has_room(plan, from, radius)) continue;
    const auto sets_out = [&](Vec2 end) {
      const path::Way way = shortest(map, radius, from, end);
      return way.status == path::RouteStatus::Ok ? way.points[1] : from;
    };
    for (int step = 0; step < 40; ++step) {
      const Vec2 middle = (to + other) / 2.0;
      (glm::distance(sets_out(middle), sets_out(to)) < 0.01 ? to : other) = middle;
    }
    const Vec2 along = place_in(plan, radius, random) - to;
    for (const double aside : {-1e-3, -1e-4, -1e-5, 0.0, 1e-5, 1e-4, 1e-3})
      if (const Vec2 end = to + aside * along; has_room(plan, end, radius))
        check_way(floor, map, brute, radius, from, end);
  }
}

RC_GTEST_PROP(SharpTips, HaveTheWaysThatBruteForceFinds, ()) {
  auto spikes = *rc::gen::container<std::vector<Spike>>(any_spike());
  if (spikes.size() > 7) spikes.resize(7);
  const auto plan = mended_hall(spikes);
  RC_PRE(plan.has_value());
  const Floor floor = floor_of(*plan, {0, 0.25});
  const auto map = path::make_floor_map(floor);
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const double unnamed = *rc::gen::elementOf(std::vector{2e-7, 1e-4, 0.02, 0.13, 0.4});

  check_ways(floor, *map, 0, 40, random);
  check_ways(floor, *map, 0.25, 40, random);
  check_ways(floor, *map, unnamed, 20, random);
  check_ways_near_ties(floor, *map, 0, 2, random);
  check_ways_near_ties(floor, *map, 0.25, 2, random);
}

/// Columns of three to five corners that see little of each other: from right beside a corner the
/// labels' cheapest meeting is often one that would roll backwards.
import::ImportedPlan hall_of_columns(std::mt19937& random) {
  std::uniform_real_distribution<double> share(0, 1);
  std::vector<Points> columns;
  for (int i = 0; i < 16; ++i) {
    const Vec2 centre{1 + 2 * (i % 4) + 0.3 * share(random), 1 + 2 * (i / 4) + 0.3 * share(random)};
    const int corners = 3 + static_cast<int>(random() % 3);
    const double size = 0.35 + 0.3 * share(random), turned = 6.2831853 * share(random);
    Points column;
    for (int k = 0; k < corners; ++k) {
      const double angle = turned - 6.2831853 * k / corners;
      column.push_back(centre + size * Vec2{std::cos(angle), std::sin(angle)});
    }
    columns.push_back(column);
  }
  return drawn(rectangle({0, 0}, {8, 8}), columns);
}

RC_GTEST_PROP(ShortestWayBesideACorner, IsAsShortAsBruteForceFinds, ()) {
  std::mt19937 random(*rc::gen::arbitrary<std::uint32_t>());
  const double radius = *rc::gen::elementOf(std::vector{0.1, 0.2, 0.3});
  const FloorPlan plan = mended(hall_of_columns(random));
  const Floor floor = floor_of(plan, {radius});
  const auto map = path::make_floor_map(floor);

  check_ways(floor, *map, radius, 60, random);
  check_ways_near_ties(floor, *map, radius, 20, random);
}

}  // namespace
}  // namespace docent::test::sharp_tips_test
