#include "content/import/ifc/ifc.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>

#include "runtime/model/geometry/polygon.h"
#include "tests/support/reference_data.h"

namespace docent::test::ifc_test {
namespace {

/// Two storeys of a room of 4 m by 3 m, a door in the lower one, a stair between; millimetres.
std::string two_storeys() {
  return R"(ISO-10303-21;
HEADER;
FILE_SCHEMA(('IFC2X3'));
ENDSEC;
DATA;
#1=IFCUNITASSIGNMENT((#2));
#2=IFCSIUNIT(*,.LENGTHUNIT.,.MILLI.,.METRE.);
#10=IFCBUILDINGSTOREY('s0',$,'Ground',$,$,#60,$,$,.ELEMENT.,0.);
#11=IFCBUILDINGSTOREY('s1',$,'Upper',$,$,#61,$,$,.ELEMENT.,3000.);
#12=IFCBUILDINGSTOREY('s2',$,'Roof',$,$,$,$,$,.ELEMENT.,6000.);
#13=IFCRELAGGREGATES('r0',$,$,$,#10,(#20));
#14=IFCRELAGGREGATES('r1',$,$,$,#11,(#21));
#15=IFCRELCONTAINEDINSPATIALSTRUCTURE('r2',$,$,$,(#30,#40),#10);
#20=IFCSPACE('g20',$,'001','','',#60,#50,'Hall',.ELEMENT.,.INTERNAL.,$);
#21=IFCSPACE('g21',$,'101','','',#61,#50,'K\X2\00FC\X0\che',.ELEMENT.,.INTERNAL.,$);
#30=IFCDOOR('g30',$,'Door',$,$,#62,$,$,2000.,900.);
#40=IFCSTAIR('g40',$,'Stair',$,$,#60,#70,$,.STRAIGHT_RUN_STAIR.);
#50=IFCPRODUCTDEFINITIONSHAPE($,$,(#51));
#51=IFCSHAPEREPRESENTATION($,'Body','SweptSolid',(#52));
#52=IFCEXTRUDEDAREASOLID(#53,#65,#66,2500.);
#53=IFCRECTANGLEPROFILEDEF(.AREA.,$,#54,4000.,3000.);
#54=IFCAXIS2PLACEMENT2D(#55,$);
#55=IFCCARTESIANPOINT((2000.,1500.));
#60=IFCLOCALPLACEMENT($,#65);
#61=IFCLOCALPLACEMENT(#60,#67);
#62=IFCLOCALPLACEMENT(#60,#68);
#65=IFCAXIS2PLACEMENT3D(#69,$,$);
#66=IFCDIRECTION((0.,0.,1.));
#67=IFCAXIS2PLACEMENT3D(#73,$,$);
#68=IFCAXIS2PLACEMENT3D(#74,$,$);
#69=IFCCARTESIANPOINT((0.,0.,0.));
#70=IFCPRODUCTDEFINITIONSHAPE($,$,(#71));
#71=IFCSHAPEREPRESENTATION($,'Body','Brep',(#72));
#72=IFCBOUNDINGBOX(#75,2000.,800.,3000.);
#73=IFCCARTESIANPOINT((0.,0.,3000.));
#74=IFCCARTESIANPOINT((1000.,0.,0.));
#75=IFCCARTESIANPOINT((1000.,1000.,0.));
ENDSEC;
END-ISO-10303-21;
)";
}

TEST(ReadIfc, FindsStoreysRoomsDoorsAndStairsInMetres) {
  const auto building = import::read_ifc({"house.ifc", two_storeys(), ""}, {});

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.size(), 2U);
  const import::ImportedLevel& ground = building->levels[0];
  EXPECT_EQ(ground.name, "Ground");
  EXPECT_EQ(ground.ordinal, 0);
  ASSERT_EQ(ground.rooms.size(), 1U);
  EXPECT_EQ(ground.rooms[0].name, "001 Hall");
  EXPECT_NEAR(std::abs(signed_area(ground.rooms[0].rings.at(0))), 12, 1e-9);
  ASSERT_EQ(ground.doors.size(), 1U);
  EXPECT_NEAR(ground.doors[0].width, 0.9, 1e-9);
  EXPECT_LT(glm::length(ground.doors[0].a - Vec2(1, 0)), 1e-9);
  EXPECT_EQ(building->levels[1].rooms.at(0).name, "101 Küche");
  EXPECT_EQ(building->levels[1].ordinal, 1);
  ASSERT_EQ(building->connections.size(), 1U);
  EXPECT_EQ(building->connections[0].kind, "stairs");
  EXPECT_EQ(building->connections[0].stops.at(1).level, "Upper");
}

TEST(ReadIfc, LeavesOutAStoreyWithoutSpacesWithASentence) {
  const auto building = import::read_ifc({"house.ifc", two_storeys(), ""}, {});

  ASSERT_TRUE(building);
  EXPECT_TRUE(std::ranges::any_of(building->doubts, [](const import::Doubt& doubt) {
    return doubt.message == "the storey 'Roof' has no spaces and was left out";
  }));
}

TEST(ReadIfc, EndsWhereRecordsReferToThemselves) {
  std::string text = two_storeys();
  text.replace(text.find("#60=IFCLOCALPLACEMENT($"), 23, "#60=IFCLOCALPLACEMENT(#61");

  EXPECT_TRUE(import::read_ifc({"house.ifc", text, ""}, {}));
}

TEST(ReadIfc, SaysThatAModelHasNoSpaces) {
  std::string text = two_storeys();
  for (std::size_t at = 0; (at = text.find("IFCSPACE", at)) != std::string::npos;)
    text.replace(at, 8, "IFCSLABS");

  const auto building = import::read_ifc({"house.ifc", text, ""}, {});

  ASSERT_FALSE(building);
  EXPECT_THAT(building.error().at(0).message, testing::HasSubstr("no spaces"));
}

struct Expected {
  const char* file;
  std::vector<std::size_t> rooms;
  std::size_t doors, connections;
};

/// As the facts beside the models have it.
TEST(ReadIfc, FindsAllRoomsDoorsAndStairsOfFourModels) {
  for (const Expected& expected :
       {Expected{"AC11-Institute-Var-2.ifc", {17, 18, 22, 22, 3}, 77, 4},
        Expected{"AC20-FZK-Haus.ifc", {6, 1}, 8, 1},  // Five doors and three open passages.
        Expected{"Allplan-Smiley-West.ifc", {15, 15, 20, 20}, 85, 15},
        Expected{"duplex.ifc", {10, 10}, 14, 2}}) {
    NEEDS_REFERENCE_DATA(std::string("floorplans/buildings/ifc/") + expected.file);
    std::ifstream file(reference_data() / "floorplans/buildings/ifc" / expected.file,
                       std::ios::binary);

    const auto building = import::read_ifc(
        {expected.file, std::string(std::istreambuf_iterator<char>(file), {}), ""}, {});

    ASSERT_TRUE(building) << expected.file;
    std::vector<std::size_t> rooms;
    std::size_t doors = 0;
    for (const import::ImportedLevel& level : building->levels) {
      rooms.push_back(level.rooms.size());
      doors += level.doors.size();
    }
    EXPECT_EQ(rooms, expected.rooms) << expected.file;
    EXPECT_EQ(doors, expected.doors) << expected.file;
    EXPECT_EQ(building->connections.size(), expected.connections) << expected.file;
  }
}

}  // namespace
}  // namespace docent::test::ifc_test
