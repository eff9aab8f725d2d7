#include "runtime/input/event_maker.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/runtime/input/hid_bytes.h"

namespace docent::test::event_maker_test {
namespace {

using input::Key;

/// Of a keyboard whose keys mean something else, as an AudioNav's do that is plugged in as it
/// comes.
input::EventMaker keypad(std::vector<input::KeyMeaning> meanings) {
  const auto descriptor = *input::parse_report_descriptor(boot_keyboard());
  return {descriptor, input::classify(descriptor), 0, std::move(meanings)};
}

constexpr int f23 = 0x72, f24 = 0x73, enter = 0x28;

TEST(EventMaker, GivesAKeyTheMeaningThatStaffSayItHas) {
  input::EventMaker maker =
      keypad({{{Key::Function, 23}, {Key::Left}}, {{Key::Function, 24}, {Key::Character, '7'}}});

  const auto down = maker.take(bytes({0, 0, f23, f24, 0, 0, 0, 0}), {});
  ASSERT_EQ(down.size(), 2U);
  EXPECT_EQ(down[0].kind, input::InputEvent::Kind::KeyDown);
  EXPECT_EQ(down[0].key, Key::Left);
  EXPECT_EQ(down[1].key, Key::Character);
  EXPECT_EQ(down[1].character, '7');

  const auto up = maker.lift_all();
  ASSERT_EQ(up.size(), 2U);
  EXPECT_EQ(up[0].kind, input::InputEvent::Kind::KeyUp);
  EXPECT_EQ(up[0].key, Key::Left);
}

TEST(EventMaker, LeavesOtherKeysTheirOwn) {
  input::EventMaker maker = keypad({{{Key::Function, 23}, {Key::Left}}});

  const auto down = maker.take(bytes({0, 0, enter, f24, 0, 0, 0, 0}), {});

  ASSERT_EQ(down.size(), 2U);
  EXPECT_EQ(down[0].key, Key::Enter);
  EXPECT_EQ(down[1].key, Key::Function);
}

}  // namespace
}  // namespace docent::test::event_maker_test
