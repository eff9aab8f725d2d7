#include "content/import/drawing/dxf.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "content/content_error.h"
#include "runtime/model/geometry/polygon.h"

namespace docent::test::dxf_test {
namespace {

using testing::HasSubstr;

std::string entities(const std::string& body, const std::string& before = "") {
  return before + "0\nSECTION\n2\nENTITIES\n" + body + "0\nENDSEC\n0\nEOF\n";
}

std::string complaint_about(const std::string& text) {
  try {
    import::parse_dxf("plan.dxf", text);
    return "no complaint";
  } catch (const content::ContentError& error) {
    return std::to_string(error.line) + ": " + error.what();
  }
}

TEST(Dxf, ReadsALineOnItsLayer) {
  const import::Drawing drawing =
      import::parse_dxf("plan.dxf", entities("0\nLINE\n8\nWALL\n10\n1\n20\n2\n11\n3\n21\n4\n"));

  ASSERT_EQ(drawing.segments.size(), 1U);
  EXPECT_EQ(drawing.segments[0].b, Vec2(3, 4));
  EXPECT_EQ(drawing.layers[drawing.segments[0].layer], "WALL");
}

TEST(Dxf, RoundsABulgeOfOneToAHalfCircle) {
  const import::Drawing drawing = import::parse_dxf(
      "plan.dxf",
      entities("0\nLWPOLYLINE\n8\n0\n90\n2\n70\n1\n10\n0\n20\n0\n42\n1\n10\n2\n20\n0\n42\n1\n"));

  ASSERT_EQ(drawing.rings.size(), 1U);
  EXPECT_NEAR(std::abs(signed_area(drawing.rings[0].corners)), std::numbers::pi, 0.02);
}

TEST(Dxf, PutsBlocksInTheirPlacesTurnedScaledAndInRows) {
  const std::string block =
      "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nDOOR\n10\n1\n20\n0\n"
      "0\nLINE\n8\n0\n10\n1\n20\n0\n11\n2\n21\n0\n0\nENDBLK\n0\nENDSEC\n";

  const import::Drawing drawing = import::parse_dxf(
      "plan.dxf",
      entities("0\nINSERT\n8\nDoors\n2\nDOOR\n10\n10\n20\n5\n41\n2\n42\n2\n50\n90\n70\n2\n44\n3\n",
               block));

  ASSERT_EQ(drawing.segments.size(), 2U);
  EXPECT_LT(glm::length(drawing.segments[0].a - Vec2(10, 5)), 1e-9);
  EXPECT_LT(glm::length(drawing.segments[0].b - Vec2(10, 7)), 1e-9);
  EXPECT_LT(glm::length(drawing.segments[1].a - Vec2(10, 8)), 1e-9);
  EXPECT_EQ(drawing.layers[drawing.segments[0].layer], "Doors");
}

TEST(Dxf, MirrorsWhatIsExtrudedDownwards) {
  const import::Drawing drawing = import::parse_dxf(
      "plan.dxf",
      entities("0\nARC\n8\n0\n10\n-5\n20\n1\n40\n1\n50\n0\n51\n90\n210\n0\n220\n0\n230\n-1\n"));

  ASSERT_EQ(drawing.arcs.size(), 1U);
  EXPECT_LT(glm::length(drawing.arcs[0].centre - Vec2(5, 1)), 1e-9);
  EXPECT_LT(glm::length(drawing.arcs[0].start - Vec2(4, 1)), 1e-9);
}

TEST(Dxf, LeavesOutLayersThatAreOffAndSaysHowMuch) {
  const std::string layers =
      "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n0\nLAYER\n2\nOld\n70\n0\n62\n-"
      "7\n0\nENDTAB\n0\nENDSEC\n";

  const import::Drawing drawing = import::parse_dxf(
      "plan.dxf", entities("0\nLINE\n8\nOld\n10\n0\n20\n0\n11\n1\n21\n0\n", layers));

  EXPECT_TRUE(drawing.segments.empty());
  EXPECT_EQ(drawing.left_out.at("entities on layers that are off or frozen"), 1U);
}

TEST(Dxf, KnowsTheUnitThatTheFileStates) {
  const std::string header = "0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n5\n0\nENDSEC\n";

  EXPECT_EQ(import::parse_dxf("plan.dxf", entities("", header)).unit, "cm");
  EXPECT_FALSE(import::parse_dxf("plan.dxf", entities("")).metres_per_unit);
}

TEST(Dxf, SaysWhereItIsDamaged) {
  EXPECT_EQ(complaint_about("0\nSECTION\n2\nENTITIES\nwall\n1\n"),
            "5: this DXF has 'wall' where a group code belongs, a number");
  EXPECT_THAT(complaint_about("0\nSECTION\n2"), HasSubstr("ends after a group code"));
  EXPECT_THAT(complaint_about("0\nSECTION\n2\nHEADER\n0\nEOF\n"), HasSubstr("no ENTITIES"));
  EXPECT_THAT(complaint_about("AC1027xxxxxxx"), HasSubstr("DWG"));
  EXPECT_THAT(complaint_about("AutoCAD Binary DXF\r\n"), HasSubstr("binary"));
}

TEST(Dxf, EndsWithASentenceWhereBlocksHoldThemselves) {
  std::string blocks = "0\nSECTION\n2\nBLOCKS\n0\nBLOCK\n2\nA\n10\n0\n20\n0\n";
  for (int i = 0; i < 8; ++i) blocks += "0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n0\n";
  blocks += "0\nENDBLK\n0\nENDSEC\n";

  EXPECT_THAT(complaint_about(entities("0\nINSERT\n8\n0\n2\nA\n10\n0\n20\n0\n", blocks)),
              HasSubstr("without end"));
}

}  // namespace
}  // namespace docent::test::dxf_test
