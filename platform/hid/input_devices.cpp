#include "platform/hid/input_devices.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <memory>
#include <thread>

#include "platform/hid/device_log.h"
#include "platform/hid/device_reader.h"
#include "platform/hid/hid_devices.h"
#include "platform/hid/touch_device.h"
#include "platform/hid/uevents.h"
#include "platform/journal/journal.h"
#include "runtime/input/event_maker.h"
#include "runtime/model/last_catch.h"

namespace docent::hid {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 50ms;  // how long the supervisor may overlook that it should stop
constexpr std::chrono::milliseconds rescan_every = 2s;           // in case an uevent was missed
constexpr std::chrono::milliseconds rescan_of_failures = 250ms;  // while udev gives permissions
constexpr auto node_appears = 20ms;                              // after its uevent
constexpr std::size_t max_devices = 16;

/// A place for one device: its queue stays when the device goes, so the frame thread can always
/// look into it.
struct Slot {
  std::string path;  ///< Empty while free. Only the supervisor touches it.
  DeviceReader reader;
};

}  // namespace

struct InputDevices::State {
  std::vector<std::string> only;            ///< Paths asked for; all devices when empty.
  std::vector<input::NamedKeypad> keypads;  ///< That staff have named.
  std::array<Slot, max_devices> slots;
  DeviceLog log;  ///< The supervisor's.
  std::jthread supervisor;

  bool is_asked_for(const std::string& path) const {
    return only.empty() || std::find(only.begin(), only.end(), path) != only.end();
  }

  void free_slots_of_gone_devices() {
    for (Slot& slot : slots)
      if (!slot.path.empty() && !slot.reader.is_reading()) {
        slot.reader.stop();
        journal::tell(journal::Message::DeviceGone, slot.path + ": is gone");
        slot.path.clear();
      }
  }

  bool is_taken_up(const HidDevice& device) const {
    return std::ranges::any_of(slots, [&](const Slot& s) { return s.path == device.path; });
  }

  /// Why it cannot be used, where it cannot.
  Result<void> take_up(const HidDevice& device) {
    if (!device.unreadable.empty())
      return std::unexpected(Error{Errc::Environment, device.unreadable});
    const auto free = std::ranges::find_if(slots, [](const Slot& s) { return s.path.empty(); });
    if (free == slots.end())
      return std::unexpected(Error{
          Errc::Environment,
          fmt::format("{}: is not used, because {} devices are; unplug one that is not needed",
                      device.path, max_devices)});
    auto opened = TouchDevice::open(device.path);
    if (!opened) return std::unexpected(opened.error());
    start_reading(*free, device, std::move(*opened));
    return {};
  }

  void start_reading(Slot& slot, const HidDevice& device, TouchDevice opened) {
    const auto number = static_cast<std::uint32_t>(&slot - slots.data());
    const input::EventMaker maker(device.descriptor, device.kind,
                                  (number + 1) * input::EventMaker::ids_per_device,
                                  input::meanings_of(candidate_of(device), keypads));
    const auto file = std::make_shared<TouchDevice>(std::move(opened));  // std::function copies
    slot.reader.start({.read = [file](std::chrono::milliseconds wait) { return file->read(wait); },
                       .is_present = [file] { return file->is_present(); }},
                      maker);
    slot.path = device.path;
    journal::tell(journal::Message::DeviceTaken,
                  fmt::format("{}: {} is read as a {}", device.path, device.name,
                              device.kind.touch ? "touch screen" : "keypad"));
  }

  /// A keyboard is a sentence in the journal, once. Its keys for music may have been taken up
  /// before the rest of it appeared.
  void refuse(const HidDevice& device) {
    for (Slot& slot : slots)
      if (slot.path == device.path) slot.reader.request_stop();
    if (const auto news = log.failed(
            device.path,
            fmt::format("{}: {} is not listened to: {}; `docent hid list` tells how to let it in",
                        device.path, device.name, device.refused),
            std::chrono::steady_clock::now()))
      journal::tell(journal::Message::DeviceUnusable, *news);
  }

  void look() {
    free_slots_of_gone_devices();
    std::vector<std::string> present;
    std::vector<HidDevice> devices = list_hid_devices();
    if (only.empty()) refuse_all_but(keypads, devices);
    for (const HidDevice& device : devices) {
      present.push_back(device.path);
      if (!device.refused.empty()) {
        refuse(device);
        continue;
      }
      const bool is_for_us = is_for_visitors(device) || !device.unreadable.empty();
      if (!is_asked_for(device.path) || !is_for_us || is_taken_up(device)) continue;
      if (const Result<void> taken = take_up(device))
        log.works(device.path);
      else if (const auto news =
                   log.failed(device.path, taken.error().what, std::chrono::steady_clock::now()))
        journal::tell(journal::Message::DeviceUnusable, *news);
    }
    log.keep(present);
  }

  void supervise(const std::stop_token& stop) {
    auto uevents = Uevents::open();
    if (!uevents) journal::tell(journal::Message::DeviceUnusable, uevents.error().what);
    auto next_look = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
      if (std::chrono::steady_clock::now() >= next_look) {
        look();
        next_look = std::chrono::steady_clock::now() +
                    (log.has_failures() ? rescan_of_failures : rescan_every);
      }
      if (!uevents)
        std::this_thread::sleep_for(patience);
      else if (uevents->hidraw_changed(patience))
        // The node appears a little later. Devices that come and go all the time put off no look.
        next_look = std::min(next_look, std::chrono::steady_clock::now() + node_appears);
    }
  }
};

InputDevices::InputDevices(std::unique_ptr<State> state) : state_(std::move(state)) {}
InputDevices::InputDevices(InputDevices&&) noexcept = default;
InputDevices& InputDevices::operator=(InputDevices&&) noexcept = default;
InputDevices::~InputDevices() {
  if (!state_) return;
  state_->supervisor = {};  // first, so that nothing is taken up any more
  for (Slot& slot : state_->slots) slot.reader.request_stop();
}

Result<InputDevices> InputDevices::open(const std::vector<std::string>& paths,
                                        const std::vector<input::NamedKeypad>& keypads) {
  for (const std::string& path : paths) {
    const auto bytes = read_report_descriptor(path);
    if (!bytes) return std::unexpected(bytes.error());
    const auto descriptor = input::parse_report_descriptor(*bytes);
    if (!descriptor) return std::unexpected(descriptor.error());
    const auto opened = TouchDevice::open(path);
    if (!opened) return std::unexpected(opened.error());
  }
  auto state = std::make_unique<State>();
  state->only = paths;
  state->keypads = keypads;
  state->supervisor = std::jthread([s = state.get()](const std::stop_token& stop) {
    keep_running("looking for input devices", stop, [&] { s->supervise(stop); });
  });
  return InputDevices(std::move(state));
}

std::size_t InputDevices::arrived(std::span<input::InputEvent> out) noexcept {
  std::size_t count = 0;
  for (Slot& slot : state_->slots)
    while (count < out.size() && slot.reader.pop(out[count])) ++count;
  return count;
}

}  // namespace docent::hid
