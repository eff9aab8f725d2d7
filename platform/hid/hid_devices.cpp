#include "platform/hid/hid_devices.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <span>

#include "platform/file/read_file.h"
#include "platform/handle.h"
#include "platform/hid/touch_device.h"

namespace docent::hid {
namespace {

/// Names come as wide characters; what is not plain text is shown as a question mark.
std::string narrow(const wchar_t* text) {
  std::string out;
  for (; text != nullptr && *text != 0; ++text)
    out.push_back(*text >= 0x20 && *text < 0x7f ? static_cast<char>(*text) : '?');
  return out;
}

HidDevice describe(const hid_device_info& info) {
  HidDevice device;
  device.path = info.path;
  device.name = narrow(info.product_string);
  device.vendor = info.vendor_id;
  device.product = info.product_id;
  const auto bytes = read_report_descriptor(device.path);
  if (!bytes) {
    device.unreadable = bytes.error().what;
    return device;
  }
  device.descriptor_hash = input::descriptor_hash(*bytes);
  auto descriptor = input::parse_report_descriptor(*bytes);
  if (!descriptor) {
    device.unreadable = descriptor.error().what;
    return device;
  }
  device.descriptor = std::move(*descriptor);
  device.kind = input::classify(device.descriptor, {device.vendor, device.product});
  return device;
}

}  // namespace

void try_to_open(std::span<HidDevice> devices) {
  for (HidDevice& device : devices)
    if (const auto opened = TouchDevice::open(device.path); !opened)
      device.closed = without_file(opened.error(), device.path);
}

input::KeypadCandidate candidate_of(const HidDevice& device) noexcept {
  return {.id = {device.vendor, device.product},
          .descriptor = device.descriptor_hash,
          .has_keys = !device.kind.keys.empty(),
          .is_keyboard = input::has_all_letters(device.kind.keys)};
}

void refuse_all_but(std::span<const input::NamedKeypad> named, std::span<HidDevice> devices) {
  std::vector<input::KeypadCandidate> present;
  for (const HidDevice& device : devices) present.push_back(candidate_of(device));
  for (std::size_t i = 0; i < devices.size(); ++i)
    devices[i].refused = input::refusal(present[i], present, named);
}

bool is_for_visitors(const HidDevice& device) noexcept {
  const bool pad =
      device.kind.touch && device.kind.touch->surface == input::TouchLayout::Surface::Pad;
  return (device.kind.touch && !pad) || (!device.kind.keys.empty() && device.refused.empty());
}

Result<std::vector<std::byte>> read_report_descriptor(const std::string& path,
                                                      const std::filesystem::path& sysfs) {
  const auto node = std::filesystem::path(path).filename();
  const Result<std::string> text = file::read_file(sysfs / node / "device/report_descriptor");
  if (!text)
    return std::unexpected(
        Error{Errc::Environment,
              fmt::format("{}: its report descriptor cannot be read ({}); is the device still "
                          "plugged in?",
                          path, text.error().what)});
  const auto bytes = std::as_bytes(std::span(*text));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

std::vector<HidDevice> list_hid_devices() {
  std::vector<HidDevice> devices;
  const std::unique_ptr<hid_device_info, CloseWith<hid_free_enumeration>> all(hid_enumerate(0, 0));
  for (const hid_device_info* info = all.get(); info != nullptr; info = info->next) {
    // hidapi lists a device once for each of its top-level collections
    const bool known = std::any_of(devices.begin(), devices.end(),
                                   [&](const HidDevice& d) { return d.path == info->path; });
    if (!known) devices.push_back(describe(*info));
  }
  std::sort(devices.begin(), devices.end(),
            [](const HidDevice& a, const HidDevice& b) { return a.path < b.path; });
  return devices;
}

}  // namespace docent::hid
