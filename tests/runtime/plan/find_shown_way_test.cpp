#include "runtime/plan/find_shown_way.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "tests/runtime/path/floors.h"

namespace docent::plan::find_shown_way_test {
namespace {

/// A hall of 12 by 8 m, which is a room; the kiosk in its west looks east, an exhibit is in its
/// north-east.
class AWayFromTheKiosk : public testing::Test {
 protected:
  AWayFromTheKiosk() {
    museum_.floors.push_back(
        test::floor_of(test::drawn(test::rectangle({0, 0}, {12, 8})), {0, 0.25}));
    museum_.rooms.emplace_back().outline = {{0, 0}, {12, 0}, {12, 8}, {0, 8}};
    Exhibit& exhibit = museum_.exhibits.emplace_back();
    exhibit.placement = {{9, 8}, -glm::half_pi<double>()};
    exhibit.viewing_point = {{9, 7}, glm::half_pi<double>()};
    exhibit.place = ExhibitPlace::OnWall;
    museum_.kiosk = {{1, 2}, 0};
  }
  std::optional<interface::ShownWay> find(const interface::InterfaceState& state) const {
    const std::vector maps{path::make_floor_map(museum_.floors[0])};
    return find_shown_way(museum_, path::BuildingMap(museum_, maps),
                          directions::find_doorways(museum_, maps), state);
  }

  Museum museum_;
};

TEST_F(AWayFromTheKiosk, LeadsToTheChosenExhibit) {
  const auto way = find({.exhibit = 0});

  ASSERT_TRUE(way);
  EXPECT_EQ(way->line.front(), Vec2(1, 2));
  EXPECT_EQ(way->line.back(), Vec2(9, 7));
  EXPECT_NEAR(way->directions.metres, std::hypot(8, 5), 1e-6);
  EXPECT_EQ(way->directions.goal.room, 0U);
  EXPECT_EQ(way->directions.goal.setting, directions::Setting::OnWall);
  EXPECT_EQ(way->directions.goal.where, directions::Where::Left);
  EXPECT_TRUE(way->directions.parts.at(0).doors.empty());
}

TEST_F(AWayFromTheKiosk, IsNoneWhereNothingIsChosenOrCanBeReached) {
  EXPECT_FALSE(find({}));
  museum_.exhibits[0].viewing_point.position = {20, 4};
  EXPECT_FALSE(find({.exhibit = 0}));
}

}  // namespace
}  // namespace docent::plan::find_shown_way_test
