#include "platform/kms/hotplug.h"

#include <gtest/gtest.h>

#include <string>

namespace docent::kms {
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

TEST(Hotplug, NeverWaits) {
  Hotplug hotplug;

  for (int i = 0; i < 3; ++i) hotplug.take();
}

}  // namespace
}  // namespace docent::kms
