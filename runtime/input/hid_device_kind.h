#pragma once

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

/// A device with a touch screen is a touch screen, whatever else it offers; one with keys is a
/// keypad.
HidDeviceKind classify(const ReportDescriptor& descriptor);

}  // namespace docent::input
