#include "platform/hid/device_log.h"

#include <gmock/gmock.h>

#include <vector>

namespace docent::hid::device_log_test {
namespace {

using namespace std::chrono_literals;
using testing::Optional;

constexpr DeviceLog::Time start{};

TEST(DeviceLog, SaysOnceThatADeviceCannotBeOpened) {
  DeviceLog log;

  EXPECT_EQ(log.failed("/dev/hidraw0", "no permission", start), std::nullopt);
  EXPECT_THAT(log.failed("/dev/hidraw0", "no permission", start + 3s),
              Optional(std::string("no permission")));
  EXPECT_EQ(log.failed("/dev/hidraw0", "no permission", start + 60s), std::nullopt);
}

TEST(DeviceLog, HasPatienceWithADeviceThatIsBeingPluggedIn) {
  DeviceLog log;

  EXPECT_EQ(log.failed("/dev/hidraw0", "no permission yet", start), std::nullopt);
  EXPECT_EQ(log.failed("/dev/hidraw0", "no permission yet", start + 1s), std::nullopt);
  log.works("/dev/hidraw0");
  EXPECT_FALSE(log.has_failures());
}

TEST(DeviceLog, TellsAnotherReasonAnew) {
  DeviceLog log;
  log.failed("/dev/hidraw0", "no permission", start);
  log.failed("/dev/hidraw0", "no permission", start + 3s);

  log.failed("/dev/hidraw0", "no descriptor", start + 4s);
  EXPECT_THAT(log.failed("/dev/hidraw0", "no descriptor", start + 7s),
              Optional(std::string("no descriptor")));
}

TEST(DeviceLog, ForgetsWhatWasUnplugged) {
  DeviceLog log;
  log.failed("/dev/hidraw0", "no permission", start);
  log.failed("/dev/hidraw0", "no permission", start + 3s);

  log.keep(std::vector<std::string>{"/dev/hidraw1"});
  EXPECT_FALSE(log.has_failures());
  log.failed("/dev/hidraw0", "no permission", start + 4s);
  EXPECT_TRUE(log.failed("/dev/hidraw0", "no permission", start + 7s).has_value());
}

}  // namespace
}  // namespace docent::hid::device_log_test
