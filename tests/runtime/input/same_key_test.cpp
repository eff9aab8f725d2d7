#include "runtime/input/same_key.h"

#include <gtest/gtest.h>

namespace docent::input::same_key_test {
namespace {

InputEvent press(Key key, char character = 0) {
  return {.kind = InputEvent::Kind::KeyDown, .contact = {}, .key = key, .character = character};
}

TEST(SameKey, IsLeftOutUntilTheDelayIsOver) {
  SameKey keys(0.5);
  EXPECT_TRUE(keys.takes(press(Key::Enter), 10));
  EXPECT_FALSE(keys.takes(press(Key::Enter), 10.2));
  EXPECT_FALSE(keys.takes(press(Key::Enter), 10.49)) << "counted from the press that was taken";
  EXPECT_TRUE(keys.takes(press(Key::Enter), 10.51));
}

TEST(SameKey, IsTakenAfterAnotherKey) {
  SameKey keys(0.5);
  EXPECT_TRUE(keys.takes(press(Key::Character, '4'), 0.1));
  EXPECT_TRUE(keys.takes(press(Key::Character, '7'), 0.2));
  EXPECT_TRUE(keys.takes(press(Key::Character, '4'), 0.3));
}

TEST(SameKey, MayComeAtOnceWhereThereIsNoDelay) {
  SameKey keys(0);
  EXPECT_TRUE(keys.takes(press(Key::Down), 1));
  EXPECT_TRUE(keys.takes(press(Key::Down), 1));
}

TEST(SameKey, HasToDoWithPressesAlone) {
  SameKey keys(0.5);
  EXPECT_TRUE(keys.takes(press(Key::Up), 1));
  const InputEvent release{
      .kind = InputEvent::Kind::KeyUp, .contact = {}, .key = Key::Up, .character = 0};
  EXPECT_TRUE(keys.takes(release, 1.1));
  const InputEvent finger{.kind = InputEvent::Kind::Down, .contact = {}};
  EXPECT_TRUE(keys.takes(finger, 1.1));
  EXPECT_TRUE(keys.takes(finger, 1.1));
}

}  // namespace
}  // namespace docent::input::same_key_test
