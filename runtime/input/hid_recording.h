#pragma once

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/input/hid_device_kind.h"
#include "runtime/model/result.h"

namespace docent::input {

/// What a HID device sent, as the program hid-recorder writes it: `R:` descriptor, `N:` name, `I:`
/// bus, vendor and product, `E:` time, size and bytes of each report.
struct HidRecording {
  std::string name;
  HidDeviceId id;
  std::vector<std::byte> descriptor;
  std::vector<std::vector<std::byte>> reports;
  std::vector<std::chrono::nanoseconds> times;  ///< One for each report, of the recorder's clock.
};

/// Reads a recording; `file` names it in errors. Fails with a line and a sentence on other text.
Result<HidRecording> parse_hid_recording(std::string_view text, std::string_view file);

}  // namespace docent::input
