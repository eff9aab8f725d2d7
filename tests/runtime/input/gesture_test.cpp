#include "runtime/input/gesture.h"

#include <gtest/gtest.h>

namespace docent::input::gesture_test {
namespace {

InputEvent event(InputEvent::Kind kind, std::uint32_t id, float x, float y) {
  return {.kind = kind, .contact = {id, x, y}};
}
constexpr auto down = InputEvent::Kind::Down, move = InputEvent::Kind::Move,
               up = InputEvent::Kind::Up;

TEST(Gestures, AreAReleaseWhereTheFingerStayed) {
  GestureRecogniser gestures;
  EXPECT_FALSE(gestures.take(event(down, 1, 0.5F, 0.5F)));
  gestures.advance(0.1F);

  const auto gesture = gestures.take(event(up, 1, 0.5F, 0.5F));

  ASSERT_TRUE(gesture);
  EXPECT_EQ(gesture->kind, Gesture::Kind::Release);
  EXPECT_TRUE(gestures.fingers().empty());
}

TEST(Gestures, AreASwipeWhereItFlickedSideways) {
  GestureRecogniser gestures;
  gestures.take(event(down, 1, 0.5F, 0.5F));
  gestures.advance(0.2F);
  gestures.take(event(move, 1, 0.3F, 0.52F));

  EXPECT_EQ(gestures.take(event(up, 1, 0.3F, 0.52F))->kind, Gesture::Kind::SwipeLeft);
}

TEST(Gestures, AreNoneWhereTheContactWasCancelled) {
  GestureRecogniser gestures;
  gestures.take(event(down, 1, 0.5F, 0.5F));

  EXPECT_FALSE(gestures.take(event(InputEvent::Kind::Cancel, 1, 0.5F, 0.5F)));
  EXPECT_TRUE(gestures.fingers().empty());
  EXPECT_FALSE(gestures.take(event(up, 1, 0.5F, 0.5F)));
}

TEST(Gestures, AreNoSwipeWhereItWasSlow) {
  GestureRecogniser gestures;
  gestures.take(event(down, 1, 0.5F, 0.5F));
  gestures.advance(2);
  gestures.take(event(move, 1, 0.3F, 0.5F));

  EXPECT_EQ(gestures.take(event(up, 1, 0.3F, 0.5F))->kind, Gesture::Kind::Release);
}

TEST(Gestures, OfTwoFingersAreTwo) {
  GestureRecogniser gestures;
  gestures.take(event(down, 1, 0.2F, 0.5F));
  gestures.take(event(down, 2, 0.8F, 0.5F));
  EXPECT_EQ(gestures.fingers().size(), 2U);

  EXPECT_EQ(gestures.take(event(up, 1, 0.2F, 0.5F))->finger.at.id, 1U);
  EXPECT_EQ(gestures.take(event(up, 2, 0.8F, 0.5F))->finger.at.id, 2U);
}

TEST(Gestures, OfFingersThatNeverCameDownAreNone) {
  GestureRecogniser gestures;
  EXPECT_FALSE(gestures.take(event(up, 9, 0.5F, 0.5F)));
  for (std::uint32_t id = 0; id < 50; ++id) gestures.take(event(down, id, 0.5F, 0.5F));
  EXPECT_EQ(gestures.fingers().size(), GestureRecogniser::most_fingers);
}

}  // namespace
}  // namespace docent::input::gesture_test
