#include "content/import/drawing/svg.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "content/import/drawing/svg_path.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::test::svg_test {
namespace {

using testing::HasSubstr;

std::string picture(const std::string& body) {
  return R"(<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 400 300">)" + body + "</svg>";
}

std::string rooms() {
  std::string body = R"(<g id="rooms">)";
  for (int i = 0; i < 5; ++i) {
    const std::string x = std::to_string(60 * i);
    body += "<rect x='" + x + "' y='0' width='50' height='40'/><text x='" + x +
            "' y='25' font-size='10'>H80" + std::to_string(i) + "</text>";
  }
  return picture(body + "</g>");
}

TEST(SvgPath, ReadsEveryCommand) {
  const auto paths =
      import::parse_path("M0 0h4v3l-4 0z m10,0 c1 1 2 1 3 0 s2-1 3 0 q1 1 2 0 t2 0 a1 1 0 012 0");

  ASSERT_EQ(paths.size(), 2U);
  EXPECT_TRUE(paths[0].closed);
  EXPECT_NEAR(std::abs(signed_area(paths[0].points)), 12, 1e-9);
  EXPECT_NEAR(paths[1].points.back().x, 10 + 3 + 3 + 2 + 2 + 2, 1e-9);
}

TEST(SvgPath, EndsWhereItsDataIsWrong) {
  EXPECT_EQ(import::parse_path("M 0 0 L 1 1 L nonsense").at(0).points.size(), 2U);
  EXPECT_TRUE(import::parse_path("L").empty());
}

TEST(Svg, GivesClosedOutlinesWithTheirNamesAndYUp) {
  const auto building = import::read_svg({"floor.svg", rooms(), ""}, {.unit = "0.1"});

  ASSERT_TRUE(building);
  ASSERT_EQ(building->levels.at(0).rooms.size(), 5U);
  EXPECT_EQ(building->levels[0].rooms[0].name, "H800");
  EXPECT_NEAR(std::abs(signed_area(building->levels[0].rooms[0].rings.at(0))), 20, 1e-9);
}

TEST(Svg, ReadsARoomWithALineWithoutLengthInIt) {
  const std::string body =
      R"(<path d="M0 0H40V30H0Z"/><path d="M9 9l0 0"/><line x1="5" y1="5" x2="5" y2="5"/>)";

  const auto building = import::read_svg({"floor.svg", picture(body), ""}, {.unit = "0.1"});

  ASSERT_TRUE(building);
  EXPECT_NEAR(std::abs(signed_area(building->levels.at(0).rooms.at(0).rings.at(0))), 12, 1e-9);
}

TEST(Svg, LeavesOutWhatNoBuildingReachesAndSaysSo) {
  const std::string body =
      R"(<path d="M0 0H40V30H0Z"/><path d="M0 0H66666666666666666666666666660"/><image href="a.png"/>)";

  const auto building = import::read_svg({"floor.svg", picture(body), ""}, {.unit = "0.1"});

  ASSERT_TRUE(building);
  EXPECT_EQ(building->levels.at(0).rooms.size(), 1U);
  const auto told = std::ranges::find(building->doubts, "left-out", &import::Doubt::code);
  ASSERT_NE(told, building->doubts.end());
  EXPECT_THAT(told->message, HasSubstr("1 strokes longer or farther away"));
  EXPECT_THAT(told->message, HasSubstr("1 pictures (<image>)"));
}

TEST(Svg, AsksForItsScaleInOneSentence) {
  const auto building = import::read_svg({"floor.svg", rooms(), ""}, {});

  ASSERT_FALSE(building);
  EXPECT_EQ(building.error().at(0).code, "unknown-unit");
  EXPECT_THAT(building.error().at(0).hint, HasSubstr("--unit 0.05"));
}

TEST(Svg, PlacesWhatIsTransformed) {
  const import::Drawing drawing = import::parse_svg(
      "floor.svg",
      picture("<g transform='translate(10,20) scale(2)'><line x1='1' y1='1' x2='3' y2='1'/></g>"));

  ASSERT_EQ(drawing.segments.size(), 1U);
  EXPECT_EQ(drawing.segments[0].a, Vec2(12, -22));
  EXPECT_EQ(drawing.segments[0].b, Vec2(16, -22));
}

TEST(Svg, RefusesAnIsometricView) {
  std::string body;
  for (int i = 0; i < 12; ++i) {
    const std::string y = std::to_string(20 * i), up = std::to_string(20 * i + 50);
    body += "<line x1='0' y1='" + up + "' x2='86.6' y2='" + y + "'/><line x1='0' y1='" + y +
            "' x2='86.6' y2='" + up + "'/>";
  }

  const auto building = import::read_svg({"floor.svg", picture(body), ""}, {.unit = "0.1"});

  ASSERT_FALSE(building);
  EXPECT_THAT(building.error().at(0).message, HasSubstr("isometric"));
}

}  // namespace
}  // namespace docent::test::svg_test
