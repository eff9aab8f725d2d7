#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "runtime/input/hid_device_kind.h"
#include "runtime/model/result.h"

namespace docent {

/// A hidraw device that is present, and what it is taken for.
struct HidDevice {
  std::string path;  ///< "/dev/hidraw0".
  std::string name;
  std::uint16_t vendor = 0, product = 0;
  ReportDescriptor descriptor;
  HidDeviceKind kind;
  std::string unreadable;  ///< Why its descriptor could not be read; empty otherwise.
};

/// The hidraw devices present, one entry a device, in the order of their paths. Does not open them.
std::vector<HidDevice> list_hid_devices();

/// The report descriptor of a hidraw node, from sysfs; needs no permission on the node itself.
Result<std::vector<std::byte>> read_report_descriptor(const std::string& path);

}  // namespace docent
