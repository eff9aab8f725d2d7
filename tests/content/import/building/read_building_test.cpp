#include "content/import/building/read_building.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "content/content_error.h"
#include "content/read_source.h"
#include "tests/support/reference_data.h"

namespace docent::test::read_building_test {
namespace {

using import::ImportedBuilding;
using import::ImportedLevel;
using testing::ElementsAre;
using testing::HasSubstr;

ImportedBuilding building_of(const std::string& bytes, const std::string& file = "plan") {
  const std::vector<import::BuildingSource> sources{{.file = file, .bytes = bytes}};
  auto building = import::read_building(sources, {});
  EXPECT_TRUE(building.has_value()) << file;
  return building ? std::move(*building) : ImportedBuilding{};
}

std::string complaint_about(const std::string& bytes) {
  const std::vector<import::BuildingSource> sources{{.file = "plan", .bytes = bytes}};
  try {
    const auto building = import::read_building(sources, {});
    return building ? "" : building.error().front().message;
  } catch (const content::ContentError& error) {
    const Diagnostic told = content::to_diagnostic(error);
    return std::to_string(told.line) + ": " + told.message;
  }
}

ImportedBuilding reference(const char* file) {
  return building_of(content::read_source(reference_data() / file), file);
}

std::vector<std::size_t> rooms_of(const ImportedBuilding& building) {
  std::vector<std::size_t> rooms;
  for (const ImportedLevel& level : building.levels) rooms.push_back(level.rooms.size());
  return rooms;
}
std::vector<std::size_t> doors_of(const ImportedBuilding& building) {
  std::vector<std::size_t> doors;
  for (const ImportedLevel& level : building.levels) doors.push_back(level.doors.size());
  return doors;
}

/// Two rooms side by side with a door between them, and one above, by Simple Indoor Tagging.
constexpr const char* two_rooms_and_one_above = R"(<?xml version="1.0"?>
<osm version="0.6">
 <node id="1" lat="48.00000" lon="16.00000"/>
 <node id="2" lat="48.00000" lon="16.00010"/>
 <node id="3" lat="48.00005" lon="16.00010"><tag k="door" v="hinged"/></node>
 <node id="4" lat="48.00010" lon="16.00010"/>
 <node id="5" lat="48.00010" lon="16.00000"/>
 <node id="6" lat="48.00000" lon="16.00020"/>
 <node id="7" lat="48.00010" lon="16.00020"/>
 <node id="8" lat="48.00005" lon="16.00005"><tag k="amenity" v="toilets"/><tag k="level" v="0"/></node>
 <way id="1"><nd ref="1"/><nd ref="2"/><nd ref="3"/><nd ref="4"/><nd ref="5"/><nd ref="1"/>
  <tag k="indoor" v="room"/><tag k="level" v="0;1"/><tag k="name" v="West &amp; more"/></way>
 <way id="2"><nd ref="2"/><nd ref="6"/><nd ref="7"/><nd ref="4"/><nd ref="3"/><nd ref="2"/>
  <tag k="indoor" v="room"/><tag k="level" v="0"/><tag k="name" v="East"/></way>
</osm>
)";

TEST(ReadBuilding, TakesRoomsDoorsAndPlacesOfOpenStreetMapToTheirLevels) {
  const ImportedBuilding building = building_of(two_rooms_and_one_above);

  ASSERT_THAT(rooms_of(building), ElementsAre(2, 1));
  const ImportedLevel& ground = building.levels[0];
  EXPECT_EQ(ground.ordinal, 0);
  EXPECT_EQ(ground.rooms[0].name, "West & more");
  ASSERT_EQ(ground.doors.size(), 1U) << "the ways share its node, and it is one door";
  ASSERT_EQ(ground.places.size(), 1U);
  EXPECT_EQ(ground.places[0].kind, "toilets");
  EXPECT_TRUE(building.origin.has_value());
}

TEST(ReadBuilding, LaysLongitudeAndLatitudeFlatInMetres) {
  const ImportedBuilding building = building_of(two_rooms_and_one_above);

  const import::BuildingRing& ring = building.levels.at(0).rooms.at(0).rings.at(0);
  const auto [west, east] = std::ranges::minmax(ring, {}, &Vec2::x);
  const auto [south, north] = std::ranges::minmax(ring, {}, &Vec2::y);
  EXPECT_NEAR(east.x - west.x, 7.46, 0.02);  // 1e-4 degrees at 48 north
  EXPECT_NEAR(north.y - south.y, 11.12, 0.02);
}

TEST(ReadBuilding, RefusesWhatIsNoPlanByWhatItIs) {
  EXPECT_THAT(complaint_about(""), HasSubstr("the file is empty"));
  EXPECT_THAT(complaint_about("%PDF-1.7"), HasSubstr("a PDF"));
  EXPECT_THAT(complaint_about("AC1027..."), HasSubstr("AutoCAD"));
  EXPECT_THAT(complaint_about("<osm><way></osm>"), HasSubstr("1: "));
  EXPECT_THAT(complaint_about("{\"type\": \"FeatureCollection\"\n oops}"), HasSubstr("2: "));
  EXPECT_NE(complaint_about("<osm>" + std::string(100'000, '<')), "");
  std::string deep;
  for (int i = 0; i < 300; ++i) deep += "<a>";
  EXPECT_THAT(complaint_about("<osm>" + deep), HasSubstr("1: "));
}

/// Two drawings of one house, each with stairs in the same corner; the upper floor is smaller.
TEST(ReadBuilding, JoinsTheStairsThatTwoPlansShowOverOneAnother) {
  const auto plan = [](const char* walls) {
    std::string svg = "<svg viewBox='0 0 200 100'><path d='" + std::string(walls) + "'/>";
    for (int i = 0; i < 8; ++i) {
      const std::string x = std::to_string(150 + 3 * i);
      svg += "<line x1='" + x + "' y1='10' x2='" + x + "' y2='25'/>";
    }
    return svg + "</svg>";
  };
  const std::vector<import::BuildingSource> sources{
      {.file = "0.svg", .bytes = plan("M0 0H200V100H0Z"), .level = "0"},
      {.file = "1.svg", .bytes = plan("M100 0H200V50H100Z"), .level = "1"}};

  const auto building = import::read_building(sources, {.unit = "0.1"});

  ASSERT_TRUE(building.has_value());
  ASSERT_EQ(building->connections.size(), 1U);
  EXPECT_EQ(building->connections[0].kind, "stairs");
  ASSERT_EQ(building->connections[0].stops.size(), 2U);
  EXPECT_LT(glm::distance(building->connections[0].stops[0].position,
                          building->connections[0].stops[1].position),
            0.01)
      << "the smaller floor lies where it was drawn, not in the corner";
}

TEST(ReadBuilding, SaysThatAPbfIsDamagedWhereverAByteOfItIsWrong) {
  // A header, and a block whose group of ways (field 3) is a number instead of a message.
  const std::string header = "\x0a\x09OSMHeader\x18\x02", data = "\x0a\x07OSMData\x18\x06";
  const auto block = [](const std::string& head, const std::string& blob) {
    return std::string(3, '\0') + static_cast<char>(head.size()) + head + blob;
  };
  const std::string pbf = block(header, std::string("\x0a\x00", 2)) +
                          block(data, std::string("\x0a\x04\x12\x02\x18\x01", 6));

  EXPECT_THAT(complaint_about(pbf), HasSubstr("damaged"));
}

TEST(ReadBuilding, ReadsTheSameFromAPbfAsFromItsXml) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/osm/made-museum-a.osm.pbf");
  const ImportedBuilding pbf = reference("floorplans/buildings/osm/made-museum-a.osm.pbf");
  const ImportedBuilding xml = reference("floorplans/buildings/dirty/made-museum-a.osm");

  EXPECT_THAT(rooms_of(pbf), ElementsAre(7, 9, 6, 3));
  EXPECT_EQ(rooms_of(pbf), rooms_of(xml));
  EXPECT_EQ(doors_of(pbf), doors_of(xml));
  EXPECT_EQ(pbf.connections.size(), xml.connections.size());
}

TEST(ReadBuilding, ReadsAnImdfArchiveWithItsOpeningsAndStairs) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/imdf/spbstu-3-levels.zip");
  const ImportedBuilding building = reference("floorplans/buildings/imdf/spbstu-3-levels.zip");

  EXPECT_THAT(rooms_of(building), ElementsAre(118, 122, 34));
  const std::vector<std::size_t> doors = doors_of(building);
  EXPECT_EQ(std::reduce(doors.begin(), doors.end()), 290U);
  EXPECT_FALSE(building.connections.empty());
  const std::vector<std::size_t> few =
      rooms_of(reference("floorplans/buildings/imdf/cpc4-two-levels.zip"));
  EXPECT_THAT(few, ElementsAre(20, 13));
}

TEST(ReadBuilding, ReadsTheCellsAndPassagesOfIndoorGml) {
  NEEDS_REFERENCE_DATA("floorplans/buildings/gml/pnu-313-4F-2D.gml");
  const ImportedBuilding floor = reference("floorplans/buildings/gml/pnu-313-4F-2D.gml");
  EXPECT_THAT(rooms_of(floor), ElementsAre(54));
  EXPECT_THAT(doors_of(floor), ElementsAre(55));

  const ImportedBuilding city = reference("floorplans/buildings/gml/citygml2-lod4-building.gml");
  EXPECT_THAT(rooms_of(city), ElementsAre(1));
}

TEST(ReadBuilding, ReadsTheSpacesOfABuildingXml) {
  NEEDS_REFERENCE_DATA("floorplans/native/building_xml/office-chewlane.xml");
  const ImportedBuilding building = reference("floorplans/native/building_xml/office-chewlane.xml");

  EXPECT_THAT(rooms_of(building), ElementsAre(30));
  EXPECT_THAT(doors_of(building), ElementsAre(28));
}

}  // namespace
}  // namespace docent::test::read_building_test
