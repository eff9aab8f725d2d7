#include "runtime/plan/stretch.h"

#include <gmock/gmock.h>
#include <rapidcheck/gtest.h>

#include "runtime/model/geometry/polyline.h"
#include "tests/runtime/path/floors.h"

namespace docent::plan::stretch_test {
namespace {

constexpr double body = 0.25, roomy = body + Museum::walking_room;

/// A place of the hall with a box that a body has room at, often only just.
Vec2 any_place() {
  const auto centimetres = [](int low, int high) {
    return *rc::gen::inRange(low, high + 1) / 100.0;
  };
  const double tight = *rc::gen::inRange(0, 31) / 1000.0;
  switch (*rc::gen::inRange(0, 4)) {
    case 0:  // beside the box
      return {centimetres(500, 700), 3 - body - tight};
    case 1:
      return {7 + body + tight, centimetres(300, 500)};
    case 2:  // in a corner of the hall
      return {body + tight, 8 - body - *rc::gen::inRange(0, 31) / 1000.0};
    default:
      return {centimetres(100, 400), centimetres(100, 700)};
  }
}

RC_GTEST_PROP(AWay, OfABodyBesideAWallLeavesRoomToWalkAtTheCornersThatFollow, ()) {
  const Floor floor = test::floor_of(test::hall_with_a_box(), {roomy, body});
  const auto map = path::make_floor_map(floor);
  Museum museum;
  museum.body_radius = body;
  const Vec2 from = any_place(), to = any_place();
  const RouteKind kind = *rc::gen::elementOf(std::vector{RouteKind::Shortest, RouteKind::Skeleton});

  const path::Way way = find_way(museum, *map, kind, from, to);

  RC_ASSERT(way.status == path::RouteStatus::Ok);
  RC_ASSERT(way.points.front() == from);
  RC_ASSERT(way.points.back() == to);
  RC_ASSERT(std::abs(way.length - polyline_length(way.points)) < 1e-3);
  constexpr double step = 0.01, flattened = 1e-3;  // metres
  for (std::size_t i = 1; i < way.points.size(); ++i) {
    const Vec2 a = way.points[i - 1], b = way.points[i];
    const bool is_at_an_end = i == 1 || i + 1 == way.points.size();
    const double least = (is_at_an_end ? body : roomy) - flattened;
    for (double t = 0; t <= 1; t += step / std::max(step, glm::distance(a, b)))
      RC_ASSERT(path::clearance_at(*map, glm::mix(a, b, t)) > least);
  }
}

}  // namespace
}  // namespace docent::plan::stretch_test
