#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "runtime/model/none.h"
#include "runtime/path/offset/offset_curve.h"
#include "runtime/path/reach.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/reference_data.h"

namespace docent::test::route_test {
namespace {

constexpr double exact = 1e-6;  // metres: what the ways' points may be off

/// A floor with its map, and points on it.
struct Hall {
  explicit Hall(const FloorPlan& plan) : floor(floor_of(plan)), map(path::make_floor_map(floor)) {}
  [[nodiscard]] const FloorPlan& plan() const { return floor.plan; }
  [[nodiscard]] path::Way ask(path::RouteQuery query) const { return path::route(*map, query); }
  [[nodiscard]] bool has_room(Vec2 point, double radius) const {
    return is_inside(plan(), point) && distance_to_nearest_wall(plan(), point) > radius;
  }

  Floor floor;
  std::shared_ptr<const path::FloorMap> map;
};

path::RouteQuery skeleton(Vec2 from, Vec2 to, double radius, bool widest = false) {
  return {.kind = RouteKind::Skeleton, .from = from, .to = to, .radius = radius, .widest = widest};
}
path::RouteQuery offset(Vec2 from, Vec2 to, double distance, path::Hand hand, double radius = 0) {
  return {.kind = RouteKind::Offset,
          .from = from,
          .to = to,
          .radius = radius,
          .offset = distance,
          .hand = hand};
}

/// Is a point as far from two places of the walls, seen in clearly different directions? By brute
/// force over the walls, so it knows nothing of diagrams.
bool on_medial_axis(const FloorPlan& plan, Vec2 point, double within = exact) {
  const double nearest = distance_to_nearest_wall(plan, point);
  std::optional<Vec2> first;
  for (std::uint32_t w = 0; w < plan.vertex.size(); ++w) {
    if (distance_to_wall(plan, w, point) > nearest + within) continue;
    const Vec2 a = wall_start(plan, w), run = wall_end(plan, w) - a;
    const Vec2 foot = a + std::clamp(dot(point - a, run) / dot(run, run), 0.0, 1.0) * run;
    if (!first)
      first = foot;
    else if (glm::distance(*first, foot) > 1e-3 * nearest)
      return true;
  }
  return false;
}

/// A random hall and three points of it that keep a distance from its walls.
struct Scene {
  std::shared_ptr<Hall> hall;
  std::array<Vec2, 3> at{};
};
Scene random_scene(double radius) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  Scene scene{std::make_shared<Hall>(*plan)};
  for (Vec2& point : scene.at) {
    point = random_point();
    RC_PRE(scene.hall->has_room(point, radius));
  }
  return scene;
}

RC_GTEST_PROP(EveryWay, IsAsLongThereAsBack, ()) {
  const Scene scene = random_scene(0.1);
  const auto [a, b, c] = scene.at;
  const double distance = *rc::gen::inRange(20, 150) / 100.0;

  const auto same = [&](path::RouteQuery there, path::Hand back_hand) {
    path::RouteQuery back = there;
    std::swap(back.from, back.to);
    back.hand = back_hand;
    const path::Way out = scene.hall->ask(there), home = scene.hall->ask(back);
    RC_ASSERT(out.status == home.status);
    RC_ASSERT(std::abs(out.length - home.length) < exact);
    return out;
  };
  same({.from = a, .to = b, .radius = 0.1}, path::Hand::Shorter);
  same(skeleton(a, b, 0.1), path::Hand::Shorter);
  same(skeleton(a, b, 0, true), path::Hand::Shorter);
  same(offset(a, b, distance, path::Hand::Shorter), path::Hand::Shorter);
  same(offset(a, b, distance, path::Hand::Left), path::Hand::Right);
}

RC_GTEST_PROP(EveryWay, IsAtLeastTheShortestAndThatTheStraightLine, ()) {
  const double radius = *rc::gen::inRange(0, 40) / 100.0;
  const Scene scene = random_scene(radius);
  const auto [a, b, c] = scene.at;

  const path::Way shortest = scene.hall->ask({.from = a, .to = b, .radius = radius});
  RC_PRE(shortest.status == path::RouteStatus::Ok);
  RC_ASSERT(shortest.length >= glm::distance(a, b) - exact);
  for (const path::RouteQuery& query : {skeleton(a, b, radius), skeleton(a, b, radius, true),
                                        offset(a, b, 0.7, path::Hand::Right, radius)}) {
    const path::Way way = scene.hall->ask(query);
    RC_ASSERT(way.status == path::RouteStatus::Ok);
    RC_ASSERT(way.length >= shortest.length - exact);
    RC_ASSERT(std::ranges::adjacent_find(way.points) == way.points.end());
    RC_ASSERT(way.points.front() == a && way.points.back() == b);
    RC_ASSERT(std::abs(polyline_length(way.points) - way.length) < 0.01 * way.length + 0.01);
    RC_ASSERT(!crosses_a_wall(scene.hall->plan(), way.points));
    const double sampled = sampled_clearance(scene.hall->plan(), way.points);
    RC_ASSERT(sampled >= way.clearance_min - 2e-3);
    RC_ASSERT(sampled <= way.clearance_min + 0.01);
    RC_ASSERT(way.clearance_min >= radius - exact);
  }
}

RC_GTEST_PROP(ShortestWay, NeverGainsByADetour, ()) {
  const double radius = *rc::gen::inRange(0, 30) / 100.0;
  const Scene scene = random_scene(radius);
  const auto length = [&](Vec2 from, Vec2 to) {
    const path::Way way = scene.hall->ask({.from = from, .to = to, .radius = radius});
    return way.status == path::RouteStatus::Ok ? way.length
                                               : std::numeric_limits<double>::infinity();
  };
  const auto [a, b, c] = scene.at;

  RC_ASSERT(length(a, c) <= length(a, b) + length(b, c) + exact);
}

RC_GTEST_PROP(EveryWay, StaysOpenToThinnerBodiesAndTheShortestGrowsNoLonger, ()) {
  const double thick = *rc::gen::inRange(1, 60) / 100.0;
  const double thin = thick * *rc::gen::inRange(0, 100) / 100.0;
  const Scene scene = random_scene(thick);
  const auto [a, b, c] = scene.at;

  for (const RouteKind kind : {RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset}) {
    path::RouteQuery query{.kind = kind, .from = a, .to = b, .radius = thick};
    const path::Way thick_way = scene.hall->ask(query);
    query.radius = thin;
    const path::Way thin_way = scene.hall->ask(query);
    if (thick_way.status != path::RouteStatus::Ok) continue;
    RC_ASSERT(thin_way.status == path::RouteStatus::Ok);
    if (kind == RouteKind::Shortest) RC_ASSERT(thin_way.length <= thick_way.length + exact);
  }
}

RC_GTEST_PROP(ShortestWay, IsWhatAVisibilityGraphFinds, ()) {
  const Scene scene = random_scene(0);
  const auto [a, b, c] = scene.at;

  const path::Way way = scene.hall->ask({.from = a, .to = b});

  const double expected = brute_force_length(scene.hall->plan(), a, b);
  RC_ASSERT((way.status == path::RouteStatus::Ok) == std::isfinite(expected));
  if (way.status == path::RouteStatus::Ok) RC_ASSERT(std::abs(way.length - expected) < exact);
}

RC_GTEST_PROP(MedialAxisWay, IsOnTheAxisBetweenItsEnds, ()) {
  const double radius = *rc::gen::inRange(0, 40) / 100.0;
  const bool widest = *rc::gen::arbitrary<bool>();
  const Scene scene = random_scene(radius);
  const auto [a, b, c] = scene.at;

  const path::Way way = scene.hall->ask(skeleton(a, b, radius, widest));
  RC_PRE(way.status == path::RouteStatus::Ok);

  for (const Vec2 point : way.points)
    if (point != a && point != b) RC_ASSERT(on_medial_axis(scene.hall->plan(), point));
}

RC_GTEST_PROP(WidestWay, IsAsWideAsAnyOtherAndTheShortestOfItsWidth, ()) {
  const Scene scene = random_scene(0);
  const auto [a, b, c] = scene.at;

  const path::Way widest = scene.hall->ask(skeleton(a, b, 0, true));
  RC_PRE(widest.status == path::RouteStatus::Ok);

  for (const path::RouteQuery& query :
       {path::RouteQuery{.from = a, .to = b}, skeleton(a, b, 0),
        offset(a, b, 0.5, path::Hand::Left), offset(a, b, 2, path::Hand::Shorter),
        skeleton(a, b, widest.clearance_min * 0.7)})
    RC_ASSERT(scene.hall->ask(query).clearance_min <= widest.clearance_min + exact);
  const path::Way as_wide = scene.hall->ask(skeleton(a, b, widest.clearance_min));
  RC_ASSERT(as_wide.status == path::RouteStatus::Ok);
  RC_ASSERT(std::abs(as_wide.length - widest.length) < exact);
}

RC_GTEST_PROP(WidestWay, IsAsWideAsTheNarrowerOfTwoLegs, ()) {
  const Scene scene = random_scene(0);
  const auto width = [&](Vec2 from, Vec2 to) {
    const path::Way way = scene.hall->ask(skeleton(from, to, 0, true));
    return way.status == path::RouteStatus::Ok ? way.clearance_min : -1.0;
  };
  const auto [a, b, c] = scene.at;

  RC_ASSERT(width(a, c) >= std::min(width(a, b), width(b, c)) - exact);
}

RC_GTEST_PROP(OffsetWay, IsAtItsDistanceOrOnTheAxisWithTheWallOnTheChosenHand, ()) {
  const double distance = *rc::gen::inRange(10, 150) / 100.0;
  const path::Hand hand = *rc::gen::element(path::Hand::Left, path::Hand::Right);
  const Scene scene = random_scene(0.01);
  const auto [a, b, c] = scene.at;
  const FloorPlan& plan = scene.hall->plan();

  const path::Way way = scene.hall->ask(offset(a, b, distance, hand));
  RC_PRE(way.status == path::RouteStatus::Ok);

  const auto on_curve = [&](Vec2 p) {
    return std::abs(distance_to_nearest_wall(plan, p) - distance) < exact;
  };
  for (const Vec2 p : way.points)
    if (p != a && p != b) RC_ASSERT(on_curve(p) || on_medial_axis(plan, p));
  for (std::size_t i = 2; i + 1 < way.points.size(); ++i) {
    const Vec2 p = way.points[i - 1], q = way.points[i], middle = (p + q) / 2.0;
    if (glm::distance(p, q) < 1e-3 || !on_curve(p) || !on_curve(q)) continue;
    // Flattened axes are chords: their middles are beside the axis by up to a millimetre.
    if (on_medial_axis(plan, middle, 5e-3) ||
        distance_to_nearest_wall(plan, middle) > distance + 2e-3)
      continue;  // along the axis, or across a wide place
    for (std::uint32_t w = 0; w < plan.vertex.size(); ++w) {
      const Vec2 start = wall_start(plan, w), run = wall_end(plan, w) - start;
      if (distance_to_wall(plan, w, middle) > distance_to_nearest_wall(plan, middle) + exact)
        continue;
      const double t = std::clamp(dot(middle - start, run) / dot(run, run), 0.0, 1.0);
      const double side = cross(q - p, start + t * run - middle);
      RC_ASSERT((hand == path::Hand::Left ? side : -side) > 0);
    }
  }
}

RC_GTEST_PROP(OffsetTour, IsItsLegsInOrder, ()) {
  const Scene scene = random_scene(0.05);
  const auto [a, b, c] = scene.at;
  const path::Hand hand =
      *rc::gen::element(path::Hand::Shorter, path::Hand::Left, path::Hand::Right);

  const path::Way whole = path::tour(*scene.hall->map, offset(a, a, 0.6, hand), scene.at);
  const path::Way first = scene.hall->ask(offset(a, b, 0.6, hand));
  const path::Way second = scene.hall->ask(offset(b, c, 0.6, hand));

  RC_ASSERT((whole.status == path::RouteStatus::Ok) ==
            (first.status == path::RouteStatus::Ok && second.status == path::RouteStatus::Ok));
  RC_PRE(whole.status == path::RouteStatus::Ok);
  RC_ASSERT(std::abs(whole.length - first.length - second.length) < exact);
  RC_ASSERT(std::abs(whole.clearance_min - std::min(first.clearance_min, second.clearance_min)) <
            exact);
  RC_ASSERT(std::ranges::find(whole.points, b) != whole.points.end());
}

RC_GTEST_PROP(EveryWay, AnswersWhateverItIsAsked, ()) {
  const auto plan = random_hall();
  RC_PRE(plan.has_value());
  const Hall hall(*plan);
  const auto any_number = [] {
    return *rc::gen::element(std::numeric_limits<double>::quiet_NaN(), infinity, -infinity, 1e300,
                             -1e300, 1e-300, 0.0, -1.0, 1.0, 3.0, 5.0, 7.0, 1e9);
  };
  path::RouteQuery query{
      .kind = *rc::gen::element(RouteKind::Shortest, RouteKind::Skeleton, RouteKind::Offset),
      .from = {any_number(), any_number()},
      .to = {any_number(), any_number()},
      .radius = any_number(),
      .offset = any_number(),
      .hand = *rc::gen::element(path::Hand::Shorter, path::Hand::Left, path::Hand::Right),
      .widest = *rc::gen::arbitrary<bool>(),
      .smooth = *rc::gen::arbitrary<bool>()};
  const bool same_ends = *rc::gen::arbitrary<bool>();
  if (same_ends) query.to = query.from;

  const path::Way way = hall.ask(query);

  const bool ok = way.status == path::RouteStatus::Ok;
  RC_ASSERT(ok == !way.points.empty());
  if (ok) {
    RC_ASSERT(std::isfinite(way.length) && std::isfinite(way.clearance_min));
    RC_ASSERT(way.points.size() >= 2U);
    for (const Vec2 p : way.points) RC_ASSERT(std::isfinite(p.x) && std::isfinite(p.y));
    RC_ASSERT(is_inside(*plan, query.from) || path::clearance_at(*hall.map, query.from) < exact);
  }
  const std::array places{query.from, query.to, Vec2{1, 1}};
  for (const path::Reached& reached :
       path::places_in_reach(*hall.map, query.from, places, query.radius))
    RC_ASSERT(std::isfinite(reached.length));
  const path::OffsetCurve curve = path::offset_curve(*hall.map, query.offset);
  RC_ASSERT(std::isfinite(curve.area) && std::isfinite(curve.perimeter));
}

/// The same on real floors and on museums with hundreds of cases, as far as the data is there.
class OnReferenceMaps : public testing::TestWithParam<const char*> {};

TEST_P(OnReferenceMaps, WaysKeepWhatTheyPromise) {
  NEEDS_REFERENCE_DATA("floorplans/reference/maps");
  const Hall hall(mended(read_polymap(reference_data() / "floorplans/reference/maps" /
                                      (std::string(GetParam()) + ".json"))
                             .plan));
  const auto [low, high] = [&] {
    Vec2 least = hall.plan().vertex[0], most = least;
    for (const Vec2 v : hall.plan().vertex) {
      least = glm::min(least, v);
      most = glm::max(most, v);
    }
    return std::pair(least, most);
  }();
  // Points of a low-discrepancy sequence (Roberts 2018), so that every run asks the same.
  std::vector<Vec2> points;
  for (int i = 1; points.size() < 16 && i < 5000; ++i) {
    const Vec2 unit{std::fmod(0.7548776662 * i, 1), std::fmod(0.5698402909 * i, 1)};
    const Vec2 point = low + unit * (high - low);
    if (hall.has_room(point, 0.25)) points.push_back(point);
  }
  ASSERT_EQ(points.size(), 16U);

  int found = 0;
  for (std::size_t i = 0; i < points.size(); i += 2) {
    const Vec2 a = points[i], b = points[i + 1];
    const path::Way shortest = hall.ask({.from = a, .to = b, .radius = 0.25});
    for (const path::RouteQuery& query :
         {skeleton(a, b, 0.25), skeleton(a, b, 0, true), offset(a, b, 1, path::Hand::Shorter, 0.25),
          offset(a, b, 0.5, path::Hand::Left, 0.25)}) {
      const path::Way way = hall.ask(query);
      SCOPED_TRACE(testing::Message()
                   << "pair " << i / 2 << ", kind " << static_cast<int>(query.kind) << ", widest "
                   << query.widest);
      if (query.radius > 0) {
        ASSERT_EQ(way.status, shortest.status);
      }
      if (way.status != path::RouteStatus::Ok) continue;
      ++found;
      if (shortest.status == path::RouteStatus::Ok && query.radius > 0) {
        EXPECT_GE(way.length, shortest.length - exact);
      }
      EXPECT_GE(way.clearance_min, query.radius - exact);
      EXPECT_FALSE(crosses_a_wall(hall.plan(), way.points));
      for (const Vec2 p : way.points) {
        EXPECT_GE(distance_to_nearest_wall(hall.plan(), p), way.clearance_min - exact);
        const bool on_curve =
            query.kind == RouteKind::Offset &&
            std::abs(distance_to_nearest_wall(hall.plan(), p) - query.offset) < exact;
        EXPECT_TRUE(p == a || p == b || on_curve || on_medial_axis(hall.plan(), p));
      }
    }
  }
  EXPECT_GT(found, 8);
}

INSTANTIATE_TEST_SUITE_P(, OnReferenceMaps,
                         testing::Values("museum-s1", "museum-m1", "westport-f2", "westport-f3",
                                         "school-rockislandgroundfloor", "sfo-intl-mainhall"));

}  // namespace
}  // namespace docent::test::route_test
