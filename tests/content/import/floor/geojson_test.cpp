#include "content/import/floor/geojson.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <fstream>
#include <limits>
#include <string>

#include "content/content_error.h"
#include "content/import/floor/projection.h"
#include "tests/support/reference_data.h"
#include "tests/support/temporary_folder.h"
#include "tests/support/wide_text.h"

namespace docent::test::geojson_test {
namespace {

using testing::HasSubstr;

import::ImportedPlan parse(std::string_view text,
                           import::Coordinates coordinates = import::Coordinates::Metres) {
  const import::GeoJsonText source{"floor.geojson", text};
  return import::parse_floor_plan({&source, 1}, coordinates);
}

/// What the reader says of a text that it cannot use, as "line:column: sentence".
std::string complaint_about(std::string_view text,
                            import::Coordinates coordinates = import::Coordinates::Metres) {
  try {
    parse(text, coordinates);
    return "no complaint";
  } catch (const content::ContentError& error) {
    EXPECT_EQ(error.file, "floor.geojson");
    return std::to_string(error.line) + ":" + std::to_string(error.column) + ": " + error.what();
  }
}

TEST(FloorPlanGeoJson, ReadsAPolygonWithItsHolesBitForBit) {
  const import::ImportedPlan plan = parse(R"({"type": "Polygon", "coordinates": [
    [[0.1, -0.2], [20.3, 1e-7], [20, 12.000000000000002], [0.1, -0.2]],
    [[5, 4, 17.5], [5, 6], [8, 6]]]})");
  ASSERT_EQ(plan.polygons.size(), 1U);
  EXPECT_EQ(plan.polygons[0].outer.vertex,
            (std::vector<Vec2>{{0.1, -0.2}, {20.3, 1e-7}, {20, 12.000000000000002}}));
  ASSERT_EQ(plan.polygons[0].holes.size(), 1U);
  EXPECT_EQ(plan.polygons[0].holes[0].vertex, (std::vector<Vec2>{{5, 4}, {5, 6}, {8, 6}}));
}

TEST(FloorPlanGeoJson, NotesWhereAHeightMayBeADecimalComma) {
  const auto doubts = [](const std::string& ring) {
    return parse(R"({"type": "Polygon", "coordinates": [)" + ring + "]}").doubtful_heights;
  };

  const auto of_a_comma = doubts("[[0, 0], [13,6, 4.8], [14,2, 5.5], [3, 9]]");
  ASSERT_EQ(of_a_comma.size(), 1U) << "once a ring";
  EXPECT_EQ(of_a_comma[0].column, 46U);
  EXPECT_EQ(doubts("[[0, 0, 4.5], [13, 0, 4.5], [3, 9, 4.5]]").size(), 0U) << "all have one";
  EXPECT_EQ(doubts("[[0.5, 0.25, 4.5], [13, 0], [3, 9]]").size(), 0U) << "no comma makes these";
}

TEST(FloorPlanGeoJson, RemembersWhereEachVertexStands) {
  const import::ImportedPlan plan =
      parse("{\"type\": \"Polygon\",\n \"coordinates\": [[[0, 0],\n  [1, 0], [0, 1]]]}");
  const auto& place = plan.polygons[0].outer.place;
  EXPECT_EQ(place[0].line, 2U);
  EXPECT_EQ(place[0].column, 19U);
  EXPECT_EQ(place[1].line, 3U);
  EXPECT_EQ(place[1].column, 3U);
  EXPECT_EQ(place[2].column, 11U);
}

TEST(FloorPlanGeoJson, ReadsCollectionsFeaturesAndMultiPolygons) {
  const import::ImportedPlan plan = parse(R"({"type": "FeatureCollection", "features": [
    {"type": "Feature", "properties": {"type": "hall"}, "geometry": {"type": "MultiPolygon",
      "coordinates": [[[[0,0],[1,0],[0,1]]], [[[5,0],[6,0],[5,1]]]]}},
    {"type": "Feature", "geometry": null},
    {"type": "Feature", "geometry": {"type": "LineString", "coordinates": [[0,0],[1,1]]}},
    {"type": "GeometryCollection", "geometries": [
      {"type": "Polygon", "coordinates": [[[9,0],[10,0],[9,1]]]}]}]})");
  EXPECT_EQ(plan.polygons.size(), 3U);
  ASSERT_EQ(plan.left_out.size(), 1U);
  EXPECT_EQ(plan.left_out[0].what, "LineString");
  EXPECT_EQ(plan.left_out[0].place.line, 5U);
}

TEST(FloorPlanGeoJson, UnitesSeveralFiles) {
  const std::string text = R"({"type":"Polygon","coordinates":[[[0,0],[1,0],[0,1]]]})";
  const std::vector<import::GeoJsonText> sources = {{"a.geojson", text}, {"b.geojson", text}};
  const import::ImportedPlan plan = import::parse_floor_plan(sources, import::Coordinates::Metres);
  ASSERT_EQ(plan.polygons.size(), 2U);
  EXPECT_EQ(plan.files[plan.polygons[1].outer.place[0].file], "b.geojson");
}

TEST(FloorPlanGeoJson, PointsAtTheMistake) {
  EXPECT_THAT(complaint_about("{\"type\": \"Polygon\",\n  oops}"),
              HasSubstr("2:3: 'oops' is no value of JSON"));
  EXPECT_THAT(complaint_about(""), HasSubstr("the file is empty"));
  EXPECT_EQ(complaint_about("[1, 2]"), "1:1: a GeoJSON object belongs here");
  EXPECT_EQ(complaint_about("{\"name\": 1}"),
            "1:1: this object has no \"type\", so it is not GeoJSON");
  EXPECT_EQ(complaint_about("{\"type\": 3}"), "1:10: a \"type\" must be a text");
  EXPECT_EQ(complaint_about("{\"type\": \"Polygone\"}"),
            "1:1: 'Polygone' is not a type of GeoJSON");
  EXPECT_EQ(complaint_about("{\"type\": \"Polygon\"}"), "1:1: this Polygon has no \"coordinates\"");
  EXPECT_EQ(complaint_about(R"({"type": "Polygon", "coordinates": {}})"),
            "1:36: \"coordinates\" must be a list");
  EXPECT_EQ(complaint_about(R"({"type": "Polygon", "coordinates": [[0, 0]]})"),
            "1:38: a point must be a list of two numbers");
  EXPECT_THAT(complaint_about(R"({"type": "Polygon", "coordinates": [[[0]]]})"),
              HasSubstr("1:38: a point needs two numbers"));
}

TEST(FloorPlanGeoJson, RefusesCoordinatesThatAreNoFiniteNumbers) {
  const auto ring = [](const std::string& coordinate) {
    return R"({"type":"Polygon","coordinates":[[[0,0],[)" + coordinate + ",0],[0,1]]]}";
  };
  EXPECT_EQ(complaint_about(ring("\"NaN\"")), "1:42: a coordinate must be a finite number");
  EXPECT_EQ(complaint_about(ring("1e999")), "1:42: a number is too large");
  EXPECT_EQ(complaint_about(ring("null")), "1:42: a coordinate must be a finite number");
  EXPECT_THAT(complaint_about(ring("NaN")), HasSubstr("1:42: 'NaN' is no value of JSON"));
  EXPECT_THAT(complaint_about(ring("1e12")), HasSubstr("1:42: the coordinate 1"));
}

TEST(FloorPlanGeoJson, RefusesAnOutlineWithoutArea) {
  EXPECT_EQ(complaint_about(R"({"type":"Polygon","coordinates":[[[0,0],[10,0],[0,0]]]})"),
            "1:34: the outer ring has 2 different points, and an area needs three");
  EXPECT_THAT(complaint_about(R"({"type":"FeatureCollection","features":[]})"),
              HasSubstr("there is no floor to walk on"));
}

TEST(FloorPlanGeoJson, RefusesDegreesOutsideTheGlobe) {
  EXPECT_THAT(complaint_about(R"({"type":"Polygon","coordinates":[[[200,0],[1,0],[0,1]]]})",
                              import::Coordinates::Wgs84),
              HasSubstr("no longitude and latitude"));
}

TEST(FloorPlanGeoJson, SurvivesNestingWithoutEnd) {
  EXPECT_THAT(complaint_about(std::string(100000, '[')), HasSubstr("nested too deeply"));
}

TEST(FloorPlanGeoJson, SaysWhichEncodingItCannotRead) {
  const std::u32string_view plan = U"{\"type\": \"Polygon\", \"coordinates\": []}";
  EXPECT_EQ(complaint_about(wide(plan, 2, ByteOrder::Little)),
            "1:1: is UTF-16 (little endian), and only UTF-8 is read");
  EXPECT_EQ(complaint_about(wide(U"\uFEFF" + std::u32string(plan), 2, ByteOrder::Big)),
            "1:1: is UTF-16 (big endian), and only UTF-8 is read");
  EXPECT_EQ(complaint_about("{\n\"name\": \"Caf\xE9\"}"),
            "2:13: is not UTF-8 but, it seems, Windows-1252 (or Latin-1): the byte 0xE9 here is "
            "'é' in it");
}

TEST(FloorPlanGeoJson, TakesAByteOrderMarkOfUtf8) {
  const TemporaryFolder folder;
  const std::string file = folder.path() / "floor.geojson";
  std::ofstream(file, std::ios::binary)
      << "\xEF\xBB\xBF" << R"({"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [0, 3]]]})";

  const import::ImportedPlan plan =
      import::read_floor_plan({&file, 1}, import::Coordinates::Metres);

  ASSERT_EQ(plan.polygons.size(), 1U);
  EXPECT_EQ(plan.polygons[0].outer.place[0].column, 38U);  // As an editor counts, without the mark.
}

TEST(FloorPlanGeoJson, SaysWhenAFileIsMissing) {
  const std::string file = "no/such/floor.geojson";
  EXPECT_THROW(import::read_floor_plan({&file, 1}, import::Coordinates::Metres),
               content::ContentError);
}

TEST(LocalProjection, MeasuresADegreeAsTheEllipsoidDoes) {
  // Lengths of a degree at 45 degrees north on WGS84 (NGA.STND.0036, table of arc lengths).
  const import::LocalProjection projection({10, 45});
  const Vec2 east = projection.to_floor({10.001, 45}), north = projection.to_floor({10, 45.001});
  EXPECT_NEAR(east.x * 1000, 78846.8, 0.1);
  EXPECT_NEAR(north.y * 1000, 111131.8, 0.1);
  EXPECT_NEAR(north.x, 0, 1e-9);
  EXPECT_EQ(projection.to_floor({10, 45}), Vec2(0, 0));
}

/// Distance in space between points of the ellipsoid: an oracle that knows no map projection.
double chord(Vec2 a_degrees, Vec2 b_degrees) {
  const auto in_space = [](Vec2 degrees) {
    constexpr double a = 6378137.0, f = 1 / 298.257223563, e2 = f * (2 - f);
    const double lat = glm::radians(degrees.y), lon = glm::radians(degrees.x);
    const double n = a / std::sqrt(1 - e2 * std::sin(lat) * std::sin(lat));
    return glm::dvec3(n * std::cos(lat) * std::cos(lon), n * std::cos(lat) * std::sin(lon),
                      n * (1 - e2) * std::sin(lat));
  };
  return glm::distance(in_space(a_degrees), in_space(b_degrees));
}

RC_GTEST_PROP(LocalProjection, KeepsDistancesWithinAKilometre, ()) {
  const Vec2 origin{*rc::gen::inRange(-180, 180), *rc::gen::inRange(-70, 71)};
  const auto near = [&] {
    return origin + Vec2{*rc::gen::inRange(-4000, 4001), *rc::gen::inRange(-4000, 4001)} * 1e-6;
  };
  const Vec2 a = near(), b = near();
  const import::LocalProjection projection(origin);
  const double flat = glm::distance(projection.to_floor(a), projection.to_floor(b));
  RC_ASSERT(std::abs(flat - chord(a, b)) < 1e-4);
}

TEST(FloorPlanGeoJson, LaysARealMuseumFlatInMetres) {
  NEEDS_REFERENCE_DATA("floorplans/native/sfomuseum");
  const std::string file =
      (reference_data() / "floorplans/native/sfomuseum/gallery-1947304211.geojson").string();
  const import::ImportedPlan plan = import::read_floor_plan({&file, 1}, import::Coordinates::Wgs84);
  double area = 0;
  for (const import::ImportedPolygon& polygon : plan.polygons) {
    const auto& ring = polygon.outer.vertex;
    for (std::size_t i = 0; i < ring.size(); ++i)
      area += cross(ring[i], ring[(i + 1) % ring.size()]) / 2;
  }
  // The file's own "geom:area" is in square degrees; a degree's lengths by the usual series.
  const double lat = glm::radians(37.6155);
  const double north = 111132.954 - 559.822 * std::cos(2 * lat) + 1.175 * std::cos(4 * lat);
  const double east =
      111412.84 * std::cos(lat) - 93.5 * std::cos(3 * lat) + 0.118 * std::cos(5 * lat);
  EXPECT_NEAR(std::abs(area), 3.8407502729402645e-9 * north * east, 0.01);
}

}  // namespace
}  // namespace docent::test::geojson_test
