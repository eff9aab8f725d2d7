#include "content/import/drawing/unit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace docent::test::unit_test {
namespace {

using testing::HasSubstr;

/// A drawing of so many units across.
import::Drawing drawing_across(double units) {
  import::Drawing drawing;
  drawing.layers = {"0"};
  for (int i = 0; i <= 100; ++i)
    drawing.segments.push_back({{units * i / 100, 0}, {units * i / 100, units}, 0});
  return drawing;
}

TEST(Unit, IsWhatTheFileStatesWhereItsDoorsAreDoors) {
  import::Drawing drawing = drawing_across(40'000);
  drawing.unit = "mm";
  drawing.metres_per_unit = 0.001;

  const import::UnitFound unit = import::find_unit(drawing, {900, 900, 1000}, "");

  EXPECT_EQ(unit.metres, 0.001);
  EXPECT_EQ(unit.doubt, "");
}

TEST(Unit, SaysThatDoorsWouldBeThirtyMillimetresWideAndFindsInches) {
  import::Drawing drawing = drawing_across(800);
  drawing.unit = "mm";
  drawing.metres_per_unit = 0.001;

  const import::UnitFound unit = import::find_unit(drawing, {30, 30, 36}, "");

  EXPECT_EQ(unit.metres, 0.0254);
  EXPECT_THAT(unit.doubt, HasSubstr("its doors are 30 mm wide; read as inches"));
}

TEST(Unit, IsAskedForWhereNothingTellsIt) {
  EXPECT_THAT(import::find_unit(drawing_across(1024), {}, "").refused,
              HasSubstr("states no unit of length, and the drawing is 819.2 units across"));
}

TEST(Unit, IsWhatStaffSay) {
  EXPECT_EQ(import::find_unit(drawing_across(10), {}, "ft").metres, 0.3048);
  EXPECT_EQ(import::find_unit(drawing_across(10), {}, "0.05").metres, 0.05);
  EXPECT_EQ(import::find_unit(drawing_across(10), {}, "parsec").refused,
            "'parsec' is no unit of length");
}

}  // namespace
}  // namespace docent::test::unit_test
