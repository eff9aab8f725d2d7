#include "runtime/guide/proximity.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

#include "runtime/guide/crowd.h"
#include "runtime/path/floor_map.h"
#include "tests/runtime/path/floors.h"
#include "tests/support/halls.h"

namespace docent::guide::proximity_test {
namespace {

using testing::ElementsAre;

constexpr double radius = 0.25;

/// A hall of 20 by 6 m in which a wall stands from (10, 0) to (10.2, 4).
const path::FloorMap& hall() {
  static const Floor floor = [] {
    test::HallMaker maker;
    const Vec2 outline[] = {{0, 0},    {10, 0}, {10, 4}, {10.2, 4},
                            {10.2, 0}, {20, 0}, {20, 6}, {0, 6}};
    maker.ring(outline);
    return test::floor_of(maker.plan, {radius});
  }();
  static const auto map = path::make_floor_map(floor);
  return *map;
}

class People {
 public:
  explicit People(const std::vector<Vec2>& places) : proximity_(hall(), 0, radius, 8) {
    for (const Vec2 place : places) {
      Agent one;
      one.is_here = true;
      one.avatar.body.position = place;
      one.avatar.plan = std::make_unique<plan::Plan>();
      agents_.push_back(std::move(one));
    }
    proximity_.look(agents_, 0.5);
  }
  /// Everybody goes so far, in half a second.
  void go(const std::vector<Vec2>& steps) {
    for (std::size_t i = 0; i < steps.size(); ++i) agents_[i].avatar.body.position += steps[i];
    proximity_.look(agents_, 0.5);
  }
  Agent& operator[](std::size_t i) { return agents_[i]; }
  const Proximity& proximity() const { return proximity_; }
  std::vector<std::uint32_t> near(std::uint32_t who) const {
    const auto agents = proximity_.near(who).agents();
    return {agents.begin(), agents.end()};
  }

 private:
  std::vector<Agent> agents_;
  Proximity proximity_;
};

TEST(Proximity, NamesWhoIsNearNowAndWhoSoonWillBeSoonestFirst) {
  People people({{2, 3}, {9, 3}, {3, 3.2}, {2, 0.5}});

  people.go({{0.5, 0}, {-0.5, 0}, {0, 0}, {0, 0}});

  EXPECT_THAT(people.near(0), ElementsAre(2, 1));
  EXPECT_THAT(people.near(3), ElementsAre());
}

TEST(Proximity, DoesNotSeeThroughWalls) {
  People people({{9.6, 1}, {10.6, 1}, {9.6, 5}, {10.6, 5}});

  EXPECT_THAT(people.near(0), ElementsAre());
  EXPECT_THAT(people.near(2), ElementsAre(3));
}

TEST(Proximity, LeavesOutWhoIsNotHereYetOrOnAnotherFloor) {
  People people({{3, 3}, {3.5, 3}, {2.5, 3}});
  people[1].is_here = false;
  people[2].avatar.floor = 1;

  people.go({});

  EXPECT_THAT(people.near(0), ElementsAre());
  EXPECT_EQ(people.proximity().collisions(), 0U);
}

TEST(Proximity, CountsWhoTouchAnotherOrAWall) {
  People people({{3, 3}, {3.4, 3}, {6, 0.1}, {8, 3}, {8.6, 3}});

  EXPECT_EQ(people.proximity().collisions(), 2U);
}

TEST(Proximity, TakesWhoHasJustAppearedToStand) {
  People people({{3, 3}, {15, 3}});
  people[1].is_here = false;
  people.go({});
  people[1].is_here = true;

  people.go({{0, 0}, {-8, 0}});

  EXPECT_THAT(people.near(0), ElementsAre());
}

}  // namespace
}  // namespace docent::guide::proximity_test
