#include "content/import/drawing/join_drawings.h"

#include <gtest/gtest.h>

namespace docent::test::join_drawings_test {
namespace {

TEST(JoinDrawings, BringsTheSecondToTheUnitOfTheFirstAndKeepsLayersApart) {
  import::Drawing walls{.layers = {"walls"},
                        .segments = {{{0, 0}, {5000, 0}}},
                        .metres_per_unit = 0.001,
                        .unit = "mm"};
  import::Drawing doors{.layers = {"doors"},
                        .segments = {{.a = {1, 0}, .b = {2, 0}, .of_curve = true, .arc = 0}},
                        .arcs = {{.centre = {1, 0}, .radius = 1}},
                        .metres_per_unit = 1,
                        .unit = "m"};

  const import::Drawing both = import::join_drawings({walls, doors});

  ASSERT_EQ(both.segments.size(), 2U);
  EXPECT_EQ(both.layers[both.segments[1].layer], "doors");
  EXPECT_EQ(both.segments[1].b, Vec2(2000, 0));
  EXPECT_EQ(both.arcs[both.segments[1].arc].radius, 1000);
}

}  // namespace
}  // namespace docent::test::join_drawings_test
