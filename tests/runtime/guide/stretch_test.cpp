// Long ways are walked in stretches: nobody may see where one takes over from another.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "runtime/path/building/building_map.h"
#include "runtime/plan/traffic.h"
#include "tests/runtime/motion/walk_measures.h"
#include "tests/support/sample_as_read.h"

namespace docent::guide::stretch_test {
namespace {

const motion::WalkGraph& walking() {
  static const motion::WalkGraph graph =
      motion::make_walk_graph(test::sample_museum().motion).value();
  return graph;
}
const path::BuildingMap& building() {
  static const path::BuildingMap building = [] {
    std::vector<std::shared_ptr<const path::FloorMap>> maps;
    for (const Floor& floor : test::sample_museum().floors)
      maps.push_back(path::make_floor_map(floor));
    return path::BuildingMap(test::sample_museum(), std::move(maps));
  }();
  return building;
}

/// For one body alone.
std::unique_ptr<plan::Plan> plan_for(const plan::WalkOrder& order) {
  return plan::Traffic(test::sample_museum(), &walking(), building(),
                       test::sample_museum().kiosk_floor)
      .plan(order);
}

const test::Quickest& recorded() {
  static const test::Quickest quickest = test::quickest(test::sample_museum().motion);
  return quickest;
}

struct Journey {
  std::vector<Placement> body;  ///< Per frame.
  std::vector<float> along;
  std::size_t stretches = 0, longest = 0;  ///< Frames of the longest walk.
  double length = 0, rate = 0;
  double haste = 0;  ///< Of its root and joints, beside the recorded motion.
};

/// Walks a way from stretch to stretch as the guide does.
Journey journey(RouteKind kind, const Placement& goal) {
  Journey out;
  plan::WalkOrder order{.floor = test::sample_museum().kiosk_floor,
                        .kind = kind,
                        .goal = goal,
                        .start = test::sample_museum().kiosk};
  std::unique_ptr<plan::Plan> plan = plan_for(order), before;
  for (;;) {
    EXPECT_EQ(plan->status, path::RouteStatus::Ok);
    const motion::Walk& walk = plan->walk;
    const std::size_t end = plan->is_whole ? walk.body.size() : plan->handover_frame;
    const auto count = static_cast<std::ptrdiff_t>(end);
    out.body.insert(out.body.end(), walk.body.begin(), walk.body.begin() + count);
    const test::Quickest moves = test::quickest(walk, 0, end);
    out.haste = std::max(out.haste, test::haste(moves, recorded()));
    out.along.insert(out.along.end(), walk.along.begin(), walk.along.begin() + count);
    out.longest = std::max(out.longest, walk.body.size());
    out.length = plan->reach.back();
    out.rate = walk.frame_rate;
    ++out.stretches;
    if (plan->is_whole || out.stretches > 200) return out;
    order = plan->order;
    before = std::move(plan);
    order.previous = before.get();
    order.previous_frame = before->handover_frame;
    order.continues = true;
    plan = plan_for(order);
  }
}

class Journeys : public testing::TestWithParam<RouteKind> {
 protected:
  std::vector<Journey> all() const {
    std::vector<Journey> journeys;
    for (const Exhibit& exhibit : test::sample_museum().exhibits)
      if (exhibit.floor == test::sample_museum().kiosk_floor)
        journeys.push_back(journey(GetParam(), exhibit.viewing_point));
    return journeys;
  }
};

TEST_P(Journeys, ArriveWhereTheyShould) {
  for (const Exhibit& exhibit : test::sample_museum().exhibits) {
    if (exhibit.floor != test::sample_museum().kiosk_floor) continue;
    const Placement last = journey(GetParam(), exhibit.viewing_point).body.back();
    EXPECT_LT(glm::distance(last.position, exhibit.viewing_point.position), 0.02) << exhibit.id;
    const double off =
        std::remainder(last.heading - exhibit.viewing_point.heading, 2 * std::numbers::pi);
    EXPECT_LT(std::abs(off), 5 * std::numbers::pi / 180) << exhibit.id;
  }
}

TEST_P(Journeys, NeverStopOnTheirWay) {
  for (const Journey& j : all()) {
    const auto edge = static_cast<std::size_t>(4 * j.rate);  // turning on the spot, starting
    int slow = 0;                                            // frames in a row
    for (std::size_t f = edge; f + edge < j.body.size(); ++f) {
      const double speed = glm::distance(j.body[f].position, j.body[f - 1].position) * j.rate;
      ASSERT_GT(speed, 0.06) << "frame " << f << " of " << j.body.size();
      // Round a sharp corner a foot may have to be set aside first: for a step, not for longer.
      slow = speed < 0.2 ? slow + 1 : 0;
      ASSERT_LT(slow, 1.5 * j.rate) << "frame " << f << " of " << j.body.size();
      ASSERT_LT(speed, 2.0) << "frame " << f;
    }
  }
}

TEST_P(Journeys, AreNoQuickerThanTheRecordedMotion) {
  for (const Journey& j : all()) EXPECT_LT(j.haste, 1.15);
}

TEST_P(Journeys, AlwaysSayHowFarTheyHaveCome) {
  for (const Journey& j : all()) {
    for (std::size_t f = 1; f < j.along.size(); ++f) ASSERT_GE(j.along[f], j.along[f - 1] - 0.03F);
    EXPECT_NEAR(j.along.back(), j.length, 0.1);
  }
}

TEST_P(Journeys, NeedNoMoreMemoryWhereTheyAreLonger) {
  std::size_t most = 0;
  for (const Journey& j : all()) {
    EXPECT_LT(j.longest, static_cast<std::size_t>(25 * j.rate));
    most = std::max(most, j.stretches);
  }
  EXPECT_GT(most, 2U);
}

TEST(CalledElsewhere, AWalkerIsNeverQuickerThanTheRecordedMotion) {
  std::mt19937 random(5);
  std::vector<Placement> views;
  for (const Exhibit& exhibit : test::sample_museum().exhibits)
    if (exhibit.floor == test::sample_museum().kiosk_floor) views.push_back(exhibit.viewing_point);
  plan::WalkOrder order{.floor = test::sample_museum().kiosk_floor,
                        .goal = views.front(),
                        .start = test::sample_museum().kiosk};
  std::unique_ptr<plan::Plan> plan = plan_for(order), before;
  for (int call = 0; call < 120; ++call) {
    before = std::move(plan);
    order.previous = before.get();
    order.previous_frame = static_cast<std::uint32_t>(random() % before->walk.root.size());
    order.kind = static_cast<RouteKind>(random() % 3);
    order.goal = views[random() % views.size()];

    plan = plan_for(order);

    const motion::Walk& walk = plan->walk;
    ASSERT_EQ(plan->status, path::RouteStatus::Ok);
    EXPECT_LT(test::haste(test::quickest(walk, 0, walk.root.size()), recorded()), 1.15) << call;
  }
}

INSTANTIATE_TEST_SUITE_P(Ways, Journeys,
                         testing::Values(RouteKind::Shortest, RouteKind::Skeleton,
                                         RouteKind::Offset),
                         [](const auto& each) {
                           return std::string(each.param == RouteKind::Shortest   ? "Shortest"
                                              : each.param == RouteKind::Skeleton ? "Skeleton"
                                                                                  : "Offset");
                         });

}  // namespace
}  // namespace docent::guide::stretch_test
