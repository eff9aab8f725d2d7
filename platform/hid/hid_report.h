#pragma once

#include <span>
#include <string>

#include "platform/hid/hid_devices.h"

namespace docent::hid {

/// "touch screen", "keypad" or "ignored".
std::string kind_of(const HidDevice& device);
/// Why it is ignored or cannot be opened, as a sentence part; empty where all is well.
std::string reason_of(const HidDevice& device);

/// What `docent hid list` prints: a line or more for each device, what it is taken for, and its
/// fields.
std::string describe_devices(std::span<const HidDevice> devices);
/// The same as JSON: an array of objects with `path name vendor product kind reason descriptor
/// fields`.
std::string describe_devices_json(std::span<const HidDevice> devices);

}  // namespace docent::hid
