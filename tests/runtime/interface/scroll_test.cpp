#include "runtime/interface/scroll.h"

#include <gtest/gtest.h>

namespace docent::interface::scroll_test {
namespace {

/// Half of the screen, with twice as much in it, and a control at its end.
View half_a_screen() {
  View view;
  view.controls = {{.name = "last", .label = {}, .action = {}, .rect = {}},
                   {.name = "text-up", .label = {}, .action = {}, .rect = {}},
                   {.name = "text-down", .label = {}, .action = {}, .rect = {}}};
  ScrollArea& area = view.scroll;
  area.rect = {0, 0.25F, 1, 0.5F};
  area.length = 1;
  area.page = 0.4F;
  area.least = 0.05F;
  area.controls = {{0, {0, 1.15F, 1, 0.1F}}};
  area.up = 1;
  area.down = 2;
  return view;
}

TEST(AScrollArea, HidesWhatLiesBeyondItsEdges) {
  const View view = half_a_screen();

  EXPECT_NEAR(seen_of(view.scroll, {0, 0.3F, 1, 0.1F}, 0).height, 0.1F, 1e-5F);
  EXPECT_NEAR(seen_of(view.scroll, {0, 0.3F, 1, 0.1F}, 0.1F).height, 0.05F, 1e-5F);
  EXPECT_EQ(seen_of(view.scroll, {0, 0.3F, 1, 0.1F}, 0.3F), scene::Rect{});
}

TEST(AScrollArea, FadesOnlyWhereItGoesOn) {
  View view = half_a_screen();
  view.scroll.fade = 0.01F;

  EXPECT_EQ(moved(view.scroll, {}, 0).clip.fade_above, 0);
  EXPECT_GT(moved(view.scroll, {}, 0).clip.fade_below, 0);
  EXPECT_GT(moved(view.scroll, {}, 0.5F).clip.fade_above, 0);
  EXPECT_EQ(moved(view.scroll, {}, 0.5F).clip.fade_below, 0);
}

TEST(AScrolledControl, IsTouchedWhereItIsSeen) {
  View view = half_a_screen();

  place_scrolled(view, 0);
  EXPECT_EQ(view.controls[0].rect, scene::Rect{});
  EXPECT_FALSE(view.controls[1].enabled);
  EXPECT_TRUE(view.controls[2].enabled);

  place_scrolled(view, 0.5F);
  EXPECT_FLOAT_EQ(view.controls[0].rect.y, 0.65F);
  EXPECT_TRUE(view.controls[1].enabled);
  EXPECT_FALSE(view.controls[2].enabled);
}

TEST(AScrolledControl, ComesIntoSightWhenKeysComeToIt) {
  const View view = half_a_screen();

  EXPECT_FLOAT_EQ(offset_showing(view.scroll, 0, 0), 0.5F);
  EXPECT_FLOAT_EQ(offset_showing(view.scroll, 2, 0.2F), 0.2F) << "it lies elsewhere";
}

}  // namespace
}  // namespace docent::interface::scroll_test
