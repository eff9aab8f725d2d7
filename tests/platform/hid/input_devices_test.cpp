#include "platform/hid/input_devices.h"

#include <gmock/gmock.h>

#include <array>

namespace docent::hid::input_devices_test {
namespace {

using testing::HasSubstr;

TEST(InputDevices, ThatWereNamedAndAreNotThereAreASentence) {
  const auto devices = InputDevices::open({"/dev/hidraw-that-is-not-there"});

  ASSERT_FALSE(devices.has_value());
  EXPECT_EQ(devices.error().code, Errc::Environment);
  EXPECT_THAT(devices.error().what, HasSubstr("/dev/hidraw-that-is-not-there"));
}

TEST(InputDevices, OfANodeThatIsNoDeviceAreASentence) {
  EXPECT_THAT(InputDevices::open({"/dev/null"}).error().what, HasSubstr("/dev/null"));
}

TEST(InputDevices, AreWaitedForWhereThereAreNone) {
  auto devices = InputDevices::open({});
  ASSERT_TRUE(devices.has_value());

  std::array<input::InputEvent, 4> events;
  EXPECT_EQ(devices->arrived(events), 0U);
}

}  // namespace
}  // namespace docent::hid::input_devices_test
