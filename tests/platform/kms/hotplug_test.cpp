#include "platform/kms/hotplug.h"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <string>

namespace docent::kms::hotplug_test {
namespace {

using namespace std::string_literals;

TEST(Hotplug, HearsOfScreensAndOfNothingElse) {
  const std::string screen =
      "change@/devices/pci0000:00/0000:00:02.0/drm/card0\0ACTION=change\0SUBSYSTEM=drm\0HOTPLUG=1\0"s;
  const std::string card = "add@/devices/drm/card1\0ACTION=add\0SUBSYSTEM=drm\0"s;
  const std::string glass = "change@/devices/hidraw0\0ACTION=change\0SUBSYSTEM=hidraw\0"s;

  EXPECT_TRUE(tells_of_screens(screen));
  EXPECT_FALSE(tells_of_screens(card));
  EXPECT_FALSE(tells_of_screens(glass));
  EXPECT_FALSE(tells_of_screens({}));
}

TEST(Hotplug, KeepsNothingOfDevicesThatComeAndGo) {
  std::array<int, 2> ends{};
  ASSERT_EQ(socketpair(AF_UNIX, SOCK_DGRAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0, ends.data()), 0);
  const FileDescriptor heard(ends[0]), told(ends[1]);
  ASSERT_TRUE(keep_changes_only(heard.get()));
  const std::string screen = "change@/devices/drm/card0\0ACTION=change\0SUBSYSTEM=drm\0"s;

  for (const std::string& message : {"add@/devices/hidraw0\0ACTION=add\0"s, "bind@/devices/uhid"s,
                                     "changes"s, "chan"s, "remove@/devices/hidraw0"s, screen})
    send(told.get(), message.data(), message.size(), 0);

  std::array<char, 200> message{};
  EXPECT_EQ(recv(heard.get(), message.data(), message.size(), 0),
            static_cast<ssize_t>(screen.size()));
  EXPECT_EQ(recv(heard.get(), message.data(), message.size(), 0), -1) << "that was all";
}

TEST(Hotplug, NeverWaits) {
  Hotplug hotplug;

  for (int i = 0; i < 3; ++i) hotplug.take();
}

}  // namespace
}  // namespace docent::kms::hotplug_test
