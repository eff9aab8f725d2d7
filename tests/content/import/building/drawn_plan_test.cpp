#include "tests/content/import/building/drawn_plan.h"

#include <gtest/gtest.h>

#include <cctype>

#include "content/import/building/read_building.h"
#include "tests/content/import/building/drawn_manners.h"

namespace docent::test::drawn_plan_test {
namespace {

class Drawings : public testing::TestWithParam<DrawnManner> {};

TEST_P(Drawings, GiveBackNineOfTenRoomsWithTheirAreaAndTheirDoors) {
  const DrawnManner& drawn = GetParam();
  const KnownFloor floor = known_floor(curved_level(2), drawn.wall);
  const import::BuildingSource source{"drawn.dxf", draw_dxf({floor}, drawn.manner), ""};

  const auto building = import::read_building({&source, 1}, {});

  ASSERT_TRUE(building) << building.error().front().message;
  ASSERT_EQ(building->levels.size(), 1U);
  const FoundShare share =
      judge(floor, building->levels[0], drawn.manner, building->moved_by.value_or(Vec2{}));
  std::string missed;
  for (const std::string& each : share.missed) missed += each + "\n";
  EXPECT_GE(10 * share.right, 9 * share.rooms) << missed;
  // Lines from jamb to jamb on the walls' own layer are told from walls where it can be known.
  EXPECT_GE(10 * share.doors_right,
            (drawn.manner.name == "one layer, thresholds" ? 7 : 9) * share.doors)
      << missed;
  EXPECT_LE(share.extra, 1U) << missed;
}

INSTANTIATE_TEST_SUITE_P(InManyManners, Drawings, testing::ValuesIn(drawn_manners()),
                         [](const testing::TestParamInfo<DrawnManner>& drawn) {
                           std::string name;
                           for (const char c : drawn.param.manner.name)
                             name += std::isalnum(static_cast<unsigned char>(c)) ? c : '_';
                           return name;
                         });

TEST(DrawingsOf, OfTwoFloorsSideBySideBecomeTwoLevels) {
  const DrawingManner manner;
  const std::vector<KnownFloor> floors{known_floor(random_level(3), 0.2),
                                       known_floor(random_level(3), 0.2)};
  const import::BuildingSource source{"drawn.dxf", draw_dxf(floors, manner), ""};

  const auto building = import::read_building({&source, 1}, {});

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.size(), 2U);
  EXPECT_EQ(building->levels[0].rooms.size(), building->levels[1].rooms.size());
}

TEST(DrawingsOf, OfOneFloorInTwoFilesAreOne) {
  const DrawingManner walls{.door_layer = "X", .doors = DoorsDrawn::Gaps, .texts = false};
  const KnownFloor floor = known_floor(random_level(2), 0.2);
  const std::string drawn = draw_dxf({floor}, walls);
  DrawingManner labels;
  labels.wall_layer = "FURNITURE";
  const std::vector<import::BuildingSource> sources{{"walls.dxf", drawn, "0"},
                                                    {"labels.dxf", draw_dxf({floor}, labels), "0"}};

  const auto building = import::read_building(sources, {});

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.size(), 1U);
  EXPECT_EQ(building->levels[0].rooms.size(), floor.rooms.size());
  EXPECT_FALSE(building->levels[0].rooms[0].name.empty());
}

TEST(DrawingsOf, InFilesThatNameTheirFloorsAreThoseFloors) {
  const std::string text = draw_dxf({known_floor(random_level(2), 0.2)}, {});
  const std::vector<import::BuildingSource> sources{
      {"museum_first_floor.dxf", text, ""}, {"museum_EG.dxf", text, ""}, {"UG.dxf", text, ""}};

  const auto building = import::read_building(sources, {});

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.size(), 3U);
  EXPECT_EQ(building->levels[0].ordinal, -1);
  EXPECT_EQ(building->levels[2].name, "1");
}

}  // namespace
}  // namespace docent::test::drawn_plan_test
