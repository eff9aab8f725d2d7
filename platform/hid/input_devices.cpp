#include "platform/hid/input_devices.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "platform/hid/device_log.h"
#include "platform/hid/hid_devices.h"
#include "platform/hid/touch_device.h"
#include "platform/hid/uevents.h"
#include "platform/journal/journal.h"
#include "runtime/input/event_queue.h"
#include "runtime/model/last_catch.h"

namespace docent::hid {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 50ms;  // how long a thread may overlook that it should stop
constexpr std::chrono::milliseconds rescan_every = 2s;           // in case an uevent was missed
constexpr std::chrono::milliseconds rescan_of_failures = 250ms;  // while udev gives permissions
constexpr auto node_appears = 20ms;                              // after its uevent
constexpr std::size_t max_devices = 16;
constexpr std::uint32_t ids_per_device = 1U << 16U;

/// Makes events of one device's reports. Reports in, events out; knows no thread and no device
/// file.
class EventMaker {
 public:
  EventMaker(const HidDevice& device, std::uint32_t first_id) : first_id_(first_id) {
    if (device.kind.touch) contacts_.emplace(device.descriptor, *device.kind.touch);
    if (!device.kind.keys.empty()) keys_.emplace(device.descriptor, device.kind.keys);
  }

  std::span<const input::InputEvent> take(std::span<const std::byte> report) noexcept {
    std::size_t count = 0;
    if (contacts_ && contacts_->take(report)) count = contact_changes(contacts_->contacts());
    if (keys_) count += key_events(keys_->take(report, edges_), count);
    return std::span(events_).first(count);
  }

  /// Everything that is down goes up: the device has gone.
  std::span<const input::InputEvent> lift_all() noexcept {
    std::size_t count = contact_changes({});
    if (keys_) count += key_events(keys_->release(edges_), count);
    return std::span(events_).first(count);
  }

 private:
  std::size_t contact_changes(std::span<const input::Contact> now) noexcept {
    std::array<input::Contact, input::max_contacts> after{};
    const std::size_t count = std::min(now.size(), after.size());
    for (std::size_t i = 0; i < count; ++i) {
      after[i] = now[i];
      after[i].id = first_id_ + now[i].id % ids_per_device;
    }
    const std::size_t events = input::contact_events(std::span(before_).first(before_count_),
                                                     std::span(after).first(count), events_);
    before_ = after;
    before_count_ = count;
    return events;
  }

  /// Makes events of the first edges, behind `first` events; returns how many.
  std::size_t key_events(std::size_t edges, std::size_t first) noexcept {
    const auto out = std::span(events_).subspan(first);
    const std::size_t count = std::min(edges, out.size());
    for (std::size_t i = 0; i < count; ++i)
      out[i] = {.kind = edges_[i].down ? input::InputEvent::Kind::KeyDown
                                       : input::InputEvent::Kind::KeyUp,
                .contact = {},
                .key = edges_[i].key.key,
                .character = edges_[i].key.character};
    return count;
  }

  std::uint32_t first_id_;
  std::optional<input::ContactDecoder> contacts_;
  std::optional<input::KeyDecoder> keys_;
  std::array<input::Contact, input::max_contacts> before_{};
  std::size_t before_count_ = 0;
  std::array<input::KeyEdge, 64> edges_{};
  std::array<input::InputEvent, 2 * input::max_contacts> events_{};
};

/// A place for one device: its queue stays when the device goes, so the frame thread can always
/// look into it.
struct Slot {
  std::string path;  ///< Empty while free. Only the supervisor touches it.
  std::atomic<bool> reading{false};
  input::EventQueue queue;
  std::jthread reader;
};

void deliver(Slot& slot, std::span<const input::InputEvent> events,
             const std::stop_token& stop) noexcept {
  for (const input::InputEvent& event : events)
    while (!slot.queue.push(event) && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
}

/// The life of a reader thread. When it ends, for whatever reason, the supervisor takes the device
/// up again if it is still there.
void read_until_gone(const std::stop_token& stop, Slot& slot, TouchDevice& device,
                     EventMaker& maker) noexcept {
  guarded("reading an input device", [&] {
    while (!stop.stop_requested() && device.is_present()) {
      const auto report = device.read(patience);
      if (!report.empty()) deliver(slot, maker.take(report), stop);
    }
  });
  deliver(slot, maker.lift_all(), stop);
  slot.reading = false;
}

}  // namespace

struct InputDevices::State {
  std::vector<std::string> only;  ///< Paths asked for; all devices when empty.
  std::array<Slot, max_devices> slots;
  DeviceLog log;  ///< The supervisor's.
  std::jthread supervisor;

  bool is_asked_for(const std::string& path) const {
    return only.empty() || std::find(only.begin(), only.end(), path) != only.end();
  }

  void free_slots_of_gone_devices() {
    for (Slot& slot : slots)
      if (!slot.path.empty() && !slot.reading) {
        slot.reader = {};
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
    EventMaker maker(device, (number + 1) * ids_per_device);
    slot.reading = true;
    slot.reader =
        std::jthread([&slot, maker, file = std::move(opened)](const std::stop_token& stop) mutable {
          read_until_gone(stop, slot, file, maker);
        });
    slot.path = device.path;
    journal::tell(journal::Message::DeviceTaken,
                  fmt::format("{}: {} is read as a {}", device.path, device.name,
                              device.kind.touch ? "touch screen" : "keypad"));
  }

  void look() {
    free_slots_of_gone_devices();
    std::vector<std::string> present;
    for (const HidDevice& device : list_hid_devices()) {
      present.push_back(device.path);
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

Result<InputDevices> InputDevices::open(const std::vector<std::string>& paths) {
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
  state->supervisor = std::jthread([s = state.get()](const std::stop_token& stop) {
    keep_running("looking for input devices", stop, [&] { s->supervise(stop); });
  });
  return InputDevices(std::move(state));
}

std::size_t InputDevices::arrived(std::span<input::InputEvent> out) noexcept {
  std::size_t count = 0;
  for (Slot& slot : state_->slots)
    while (count < out.size() && slot.queue.pop(out[count])) ++count;
  return count;
}

}  // namespace docent::hid
