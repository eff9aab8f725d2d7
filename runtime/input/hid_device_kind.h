#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/input/contact_decoder.h"
#include "runtime/input/key_decoder.h"

namespace docent::input {

/// What the kiosk takes a HID device for, from its report descriptor alone.
struct HidDeviceKind {
  std::optional<TouchLayout> touch;  ///< A touch screen, or a touch pad (then `ignored` says so).
  std::vector<ReportField>
      keys;             ///< A keypad; empty when the device is a touch screen or has no keys.
  std::string ignored;  ///< Why it is neither, as a sentence part: "a mouse"; empty otherwise.
};

/// Who made a device, as it says itself.
struct HidDeviceId {
  std::uint16_t vendor = 0, product = 0;

  bool operator==(const HidDeviceId&) const = default;
};

/// A device with a touch screen is a touch screen, whatever else it offers; one with keys is a
/// keypad. A touch screen in the table of quirks is decoded by them.
HidDeviceKind classify(const ReportDescriptor& descriptor, HidDeviceId id = {});

}  // namespace docent::input
