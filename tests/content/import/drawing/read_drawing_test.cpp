#include "content/import/drawing/read_drawing.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "runtime/model/geometry/polygon.h"
#include "tests/support/reference_data.h"

namespace docent::test::read_drawing_test {
namespace {

using testing::HasSubstr;

import::BuildingOrDiagnostics read(const std::string& name) {
  std::ifstream file(reference_data() / "floorplans/buildings/dxf" / name, std::ios::binary);
  return import::read_dxf({name, std::string(std::istreambuf_iterator<char>(file), {}), ""}, {});
}

double area_of(const import::ImportedRoom& room) {
  double area = std::abs(signed_area(room.rings.front()));
  for (std::size_t i = 1; i < room.rings.size(); ++i) area -= std::abs(signed_area(room.rings[i]));
  return area;
}

bool is_doubted(const import::ImportedBuilding& building, const std::string& code) {
  return std::ranges::count(building.doubts, code, &import::Doubt::code) > 0;
}

TEST(ReadDxf, FindsTheTwelveRoomsAndTheCorridorOfTheTestOffice) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/dxf/jps-iso-office.dxf");

  const auto building = read("jps-iso-office.dxf");

  ASSERT_TRUE(building);
  EXPECT_EQ(building->levels.at(0).rooms.size(), 13U);
  EXPECT_EQ(building->levels.at(0).doors.size(), 12U);
}

TEST(ReadDxf, TakesTheOutlinesOfASchoolWithTheAreasThatItsTextsSay) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/dxf/telecom-plan.dxf");

  const auto building = read("telecom-plan.dxf");

  ASSERT_TRUE(building);
  EXPECT_EQ(building->levels.at(0).rooms.size(), 60U);
  const auto& rooms = building->levels.at(0).rooms;
  const auto hall = std::ranges::find_if(
      rooms, [](const import::ImportedRoom& room) { return room.name.starts_with("A002"); });
  ASSERT_NE(hall, rooms.end());
  EXPECT_NEAR(area_of(*hall), 71.25, 0.05);
  EXPECT_TRUE(is_doubted(*building, "no-doors"));
}

TEST(ReadDxf, ReadsInchesThatAreMarkedAsMillimetresAndSaysSo) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/dxf/bishop-overland-inches-marked-mm.dxf");

  const auto building = read("bishop-overland-inches-marked-mm.dxf");

  ASSERT_TRUE(building);
  ASSERT_TRUE(is_doubted(*building, "unit"));
  EXPECT_THAT(building->doubts.front().message, HasSubstr("read as inches"));
}

TEST(ReadDxf, KeepsTheSectionOfAMuseumOutOfItsRooms) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/dxf/historical_museum.dxf");

  const auto building = read("historical_museum.dxf");

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.size(), 1U);
  EXPECT_GT(building->levels[0].rooms.size(), 40U);
  for (const auto& room : building->levels[0].rooms)
    for (const Vec2 corner : room.rings.front()) EXPECT_LT(corner.y, 45);
}

TEST(ReadDxf, SaysThatADrawingHoldsNoRooms) {
  std::string text =
      "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
  for (int i = 0; i < 30; ++i)
    text += "0\nLINE\n8\n0\n10\n" + std::to_string(i) + "\n20\n0\n11\n" + std::to_string(i) +
            "\n21\n20\n";

  const auto building = import::read_dxf({"plan.dxf", text + "0\nENDSEC\n0\nEOF\n", ""}, {});

  ASSERT_FALSE(building);
  EXPECT_EQ(building.error().at(0).code, "no-rooms");
}

}  // namespace
}  // namespace docent::test::read_drawing_test
