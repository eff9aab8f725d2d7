#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "runtime/input/hid_device_kind.h"
#include "runtime/input/keypad_policy.h"
#include "runtime/model/result.h"

namespace docent::hid {

/// A hidraw device that is present, and what it is taken for.
struct HidDevice {
  std::string path;  ///< "/dev/hidraw0".
  std::string name;
  std::uint16_t vendor = 0, product = 0;
  input::ReportDescriptor descriptor;
  input::HidDeviceKind kind;
  std::uint64_t descriptor_hash = 0;  ///< input::descriptor_hash() of its bytes.
  std::string unreadable;             ///< Why its descriptor could not be read; empty otherwise.
  std::string closed;   ///< Why it cannot be opened; empty where it can, or was not tried.
  std::string refused;  ///< Why its keys are not listened to; empty where they are.
};

/// Tries to open each device and notes in `closed` why one cannot be. Takes up to 50 ms for each.
void try_to_open(std::span<HidDevice> devices);

/// The device, as far as letting it in goes.
input::KeypadCandidate candidate_of(const HidDevice& device) noexcept;

/// Notes in `refused` which devices with keys are not listened to, and why.
void refuse_all_but(std::span<const input::NamedKeypad> named, std::span<HidDevice> devices);

/// Is it a touch screen, or a keypad that is listened to: a device for visitors?
bool is_for_visitors(const HidDevice& device) noexcept;

/// The hidraw devices present, one entry a device, in the order of their paths. Does not open them.
std::vector<HidDevice> list_hid_devices();

/// The report descriptor of a hidraw node, from sysfs; needs no permission on the node itself.
/// Fails with a sentence where the device is unplugged meanwhile, even between opening and reading.
Result<std::vector<std::byte>> read_report_descriptor(
    const std::string& path, const std::filesystem::path& sysfs = "/sys/class/hidraw");

}  // namespace docent::hid
