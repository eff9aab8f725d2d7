#include "runtime/guide/scroller.h"

#include <gtest/gtest.h>

namespace docent::guide::scroller_test {
namespace {

constexpr float frame = 1.0F / 60, slack = 0.01F;

interface::ScrollArea long_text() {
  interface::ScrollArea area;
  area.rect = {0, 0.2F, 0.4F, 0.5F};
  area.length = 2;
  area.page = 0.4F;
  return area;
}

input::Contact finger_at(float y) {
  return {.id = 1, .x = 0.2F, .y = y};
}

/// A finger that goes up by a fifth of the screen in ten frames.
void flick(Scroller& scroller, const interface::ScrollArea& area) {
  scroller.hold(finger_at(0.6F));
  for (int i = 1; i <= 10; ++i) {
    scroller.drag(area, finger_at(0.6F - 0.02F * static_cast<float>(i)), slack);
    scroller.advance(area, frame);
  }
  scroller.let_go(1);
}

TEST(TheScroller, FollowsAFingerAndRunsOnCalmly) {
  const interface::ScrollArea area = long_text();
  Scroller scroller(false);
  flick(scroller, area);
  const float dragged = scroller.offset();

  EXPECT_NEAR(dragged, 0.18F, 0.001F);
  for (int i = 0; i < 180; ++i) scroller.advance(area, frame);
  EXPECT_GT(scroller.offset(), dragged + 0.1F);
  EXPECT_LT(scroller.offset(), dragged + 0.5F);
  EXPECT_FALSE(scroller.is_moving());
}

TEST(TheScroller, StopsWhereTheFingerLeftItWithReducedMotion) {
  const interface::ScrollArea area = long_text();
  Scroller scroller(true);
  flick(scroller, area);
  const float dragged = scroller.offset();
  for (int i = 0; i < 60; ++i) scroller.advance(area, frame);

  EXPECT_EQ(scroller.offset(), dragged);
  scroller.turn(area, 1);
  EXPECT_FLOAT_EQ(scroller.offset(), dragged + area.page);
}

TEST(TheScroller, TakesATremblingFingerForATouch) {
  const interface::ScrollArea area = long_text();
  Scroller scroller(false);
  scroller.hold(finger_at(0.5F));

  EXPECT_FALSE(scroller.drag(area, finger_at(0.495F), slack));
  EXPECT_EQ(scroller.offset(), 0);
}

TEST(TheScroller, TurnsPagesToTheEndAndNoFurther) {
  const interface::ScrollArea area = long_text();
  Scroller scroller(false);
  for (int page = 0; page < 9; ++page) {
    scroller.turn(area, 1);
    for (int i = 0; i < 30; ++i) scroller.advance(area, frame);
  }
  EXPECT_FLOAT_EQ(scroller.offset(), area.most());

  scroller.turn(area, -1);
  for (int i = 0; i < 30; ++i) scroller.advance(area, frame);
  EXPECT_FLOAT_EQ(scroller.offset(), area.most() - area.page);
}

TEST(TheScroller, ReturnsToTheBeginningForAnotherText) {
  const interface::ScrollArea area = long_text();
  Scroller scroller(false);
  flick(scroller, area);

  scroller.enter(area, true);
  EXPECT_GT(scroller.offset(), 0);
  scroller.enter(area, false);
  EXPECT_EQ(scroller.offset(), 0);
}

}  // namespace
}  // namespace docent::guide::scroller_test
