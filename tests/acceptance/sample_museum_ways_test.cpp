#include <gtest/gtest.h>

#include "platform/sqlite/content_reader.h"
#include "tests/runtime/path/oracles.h"
#include "tests/support/sample_database.h"

namespace docent::test::sample_museum_ways_test {
namespace {

class SampleMuseum : public testing::TestWithParam<RouteKind> {};

TEST_P(SampleMuseum, LeadsBetweenAllExhibitsWithoutTouchingAWall) {
  const auto museum = sqlite::load_museum(sample_database());
  ASSERT_TRUE(museum.has_value()) << museum.error().what;
  ASSERT_GE(museum->exhibits.size(), 24U);

  for (std::uint32_t f = 0; f < museum->floors.size(); ++f) {
    const FloorPlan& plan = museum->floors[f].plan;
    const auto map = path::make_floor_map(museum->floors[f]);
    for (const Exhibit& from : museum->exhibits)
      for (const Exhibit& to : museum->exhibits) {
        if (from.floor != f || to.floor != f) continue;
        path::RouteQuery query{.kind = GetParam(), .radius = museum->body_radius};
        query.from = from.viewing_point.position;
        query.to = to.viewing_point.position;
        const path::Way way = path::route(*map, query);
        ASSERT_EQ(way.status, path::RouteStatus::Ok) << from.id << " to " << to.id;
        EXPECT_GE(way.clearance_min, museum->body_radius - 1e-6) << from.id << " to " << to.id;
        EXPECT_FALSE(crosses_a_wall(plan, way.points)) << from.id << " to " << to.id;
        for (const Vec2 point : way.points)
          ASSERT_GE(distance_to_nearest_wall(plan, point), museum->body_radius - 1e-6);
      }
  }
}

INSTANTIATE_TEST_SUITE_P(EachKind, SampleMuseum,
                         testing::Values(RouteKind::Shortest, RouteKind::Skeleton,
                                         RouteKind::Offset),
                         [](const auto& each) { return std::string(info_of(each.param).name); });

}  // namespace
}  // namespace docent::test::sample_museum_ways_test
