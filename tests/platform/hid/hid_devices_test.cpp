#include "platform/hid/hid_devices.h"

#include <gmock/gmock.h>

#include <fstream>

#include "platform/hid/hid_report.h"
#include "tests/support/temporary_folder.h"

namespace docent::hid::hid_devices_test {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A made sysfs, with one device whose descriptor is whatever a test makes it.
class ASysfs : public testing::Test {
 protected:
  ASysfs() { std::filesystem::create_directories(descriptor().parent_path()); }
  std::filesystem::path descriptor() const {
    return folder_.path() / "hidraw0/device/report_descriptor";
  }
  Result<std::vector<std::byte>> read() const {
    return read_report_descriptor("/dev/hidraw0", folder_.path());
  }

 private:
  test::TemporaryFolder folder_;
};

TEST_F(ASysfs, GivesTheDescriptorOfADevice) {
  std::ofstream(descriptor(), std::ios::binary) << "\x05\x0d";

  EXPECT_THAT(read().value_or(std::vector<std::byte>{}),
              testing::ElementsAre(std::byte{0x05}, std::byte{0x0d}));
}

// A node whose device goes between opening and reading answers the read with an error, as the first
// page of this process's memory does.
TEST_F(ASysfs, WhoseDeviceGoesWhileItIsReadGivesASentence) {
  std::filesystem::create_symlink("/proc/self/mem", descriptor());

  const auto bytes = read();

  ASSERT_FALSE(bytes.has_value());
  EXPECT_THAT(bytes.error().what, HasSubstr("/dev/hidraw0"));
  EXPECT_THAT(bytes.error().what, HasSubstr("still plugged in"));
}

TEST_F(ASysfs, WithAFolderInPlaceOfAFileGivesASentence) {
  std::filesystem::create_directory(descriptor());

  EXPECT_THAT(read().error().what, HasSubstr("is a folder"));
}

TEST_F(ASysfs, WithoutTheDeviceGivesASentence) {
  EXPECT_THAT(read().error().what, HasSubstr("report descriptor cannot be read"));
}

HidDevice keypad(const std::string& path) {
  HidDevice device;
  device.path = path;
  device.name = "Keypad";
  device.kind.keys.resize(1);
  return device;
}

TEST(ListedDevices, SayWhyOneCannotBeOpened) {
  std::vector<HidDevice> devices{keypad("/dev/hidraw-that-is-not-there")};
  EXPECT_THAT(describe_devices(devices), Not(HasSubstr("cannot open")));

  try_to_open(devices);

  EXPECT_THAT(describe_devices(devices), HasSubstr("keypad, cannot open the input device"));
  EXPECT_THAT(describe_devices_json(devices), HasSubstr("DeviceAllow=char-hidraw rw"));
}

}  // namespace
}  // namespace docent::hid::hid_devices_test
