#include "platform/hid/input_devices.h"

#include <fmt/format.h>
#include <hidapi/hidapi.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <chrono>
#include <optional>
#include <thread>

#include "platform/hid/hid_devices.h"
#include "platform/hid/touch_device.h"
#include "platform/hid/uevents.h"
#include "runtime/input/event_queue.h"

namespace docent {
namespace {

using namespace std::chrono_literals;
constexpr auto patience = 50ms;    // how long a thread may overlook that it should stop
constexpr auto rescan_every = 2s;  // in case an uevent was missed
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

  std::span<const InputEvent> take(std::span<const std::byte> report) noexcept {
    std::size_t count = 0;
    if (contacts_ && contacts_->take(report)) count = contact_changes(contacts_->contacts());
    if (keys_) count += key_changes(report, std::span(events_).subspan(count));
    return std::span(events_).first(count);
  }

  /// Everything that is down goes up: the device has gone.
  std::span<const InputEvent> lift_all() noexcept {
    return std::span(events_).first(contact_changes({}));
  }

 private:
  std::size_t contact_changes(std::span<const Contact> now) noexcept {
    std::array<Contact, max_contacts> after{};
    const std::size_t count = std::min(now.size(), after.size());
    for (std::size_t i = 0; i < count; ++i) {
      after[i] = now[i];
      after[i].id = first_id_ + now[i].id % ids_per_device;
    }
    const std::size_t events = contact_events(std::span(before_).first(before_count_),
                                              std::span(after).first(count), events_);
    before_ = after;
    before_count_ = count;
    return events;
  }

  std::size_t key_changes(std::span<const std::byte> report, std::span<InputEvent> out) noexcept {
    std::array<KeyEdge, 64> edges;
    const std::size_t count = std::min(keys_->take(report, edges), out.size());
    for (std::size_t i = 0; i < count; ++i)
      out[i] = {.kind = edges[i].down ? InputEvent::Kind::KeyDown : InputEvent::Kind::KeyUp,
                .contact = {},
                .key = edges[i].key.key,
                .character = edges[i].key.character};
    return count;
  }

  std::uint32_t first_id_;
  std::optional<ContactDecoder> contacts_;
  std::optional<KeyDecoder> keys_;
  std::array<Contact, max_contacts> before_{};
  std::size_t before_count_ = 0;
  std::array<InputEvent, 2 * max_contacts> events_{};
};

/// A place for one device: its queue stays when the device goes, so the frame thread can always
/// look into it.
struct Slot {
  std::string path;  ///< Empty while free. Only the supervisor touches it.
  std::atomic<bool> reading{false};
  EventQueue queue;
  std::jthread reader;
};

bool is_wanted(const HidDevice& device) {
  const bool pad = device.kind.touch && device.kind.touch->surface == TouchLayout::Surface::Pad;
  return (device.kind.touch && !pad) || !device.kind.keys.empty();
}

void deliver(Slot& slot, std::span<const InputEvent> events, const std::stop_token& stop) {
  for (const InputEvent& event : events)
    while (!slot.queue.push(event) && !stop.stop_requested()) std::this_thread::sleep_for(1ms);
}

void read_until_gone(const std::stop_token& stop, Slot& slot, TouchDevice device,
                     EventMaker maker) {
  while (!stop.stop_requested() && device.is_present()) {
    const auto report = device.read(patience);
    if (!report.empty()) deliver(slot, maker.take(report), stop);
  }
  deliver(slot, maker.lift_all(), stop);
  slot.reading = false;
}

}  // namespace

struct InputDevices::State {
  std::vector<std::string> only;  ///< Paths asked for; all devices when empty.
  std::array<Slot, max_devices> slots;
  std::jthread supervisor;

  bool is_asked_for(const std::string& path) const {
    return only.empty() || std::find(only.begin(), only.end(), path) != only.end();
  }

  void free_slots_of_gone_devices() {
    for (Slot& slot : slots)
      if (!slot.path.empty() && !slot.reading) {
        slot.reader = {};
        slot.path.clear();
      }
  }

  void take_up(const HidDevice& device) {
    const auto in_use = [&](const Slot& s) { return s.path == device.path; };
    if (std::any_of(slots.begin(), slots.end(), in_use)) return;
    const auto free =
        std::find_if(slots.begin(), slots.end(), [](const Slot& s) { return s.path.empty(); });
    if (free == slots.end()) return;
    auto opened = TouchDevice::open(device.path);
    if (!opened) return;  // not ready yet, or not ours: the next look tries again
    Slot& slot = *free;
    slot.path = device.path;
    slot.reading = true;
    const auto number = static_cast<std::uint32_t>(free - slots.begin());
    EventMaker maker(device, (number + 1) * ids_per_device);
    slot.reader = std::jthread(
        [&slot, maker, device_file = std::move(*opened)](const std::stop_token& stop) mutable {
          read_until_gone(stop, slot, std::move(device_file), maker);
        });
  }

  void look() {
    free_slots_of_gone_devices();
    for (const HidDevice& device : list_hid_devices())
      if (is_asked_for(device.path) && is_wanted(device)) take_up(device);
  }

  void supervise(const std::stop_token& stop) {
    auto uevents = Uevents::open();
    auto next_look = std::chrono::steady_clock::now();
    while (!stop.stop_requested()) {
      if (std::chrono::steady_clock::now() >= next_look) {
        look();
        next_look = std::chrono::steady_clock::now() + rescan_every;
      }
      if (!uevents)
        std::this_thread::sleep_for(patience);
      else if (uevents->hidraw_changed(patience))
        next_look = std::chrono::steady_clock::now() + 20ms;  // the node appears a little later
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
    const auto descriptor = parse_report_descriptor(*bytes);
    if (!descriptor) return std::unexpected(descriptor.error());
    const auto opened = TouchDevice::open(path);
    if (!opened) return std::unexpected(opened.error());
  }
  auto state = std::make_unique<State>();
  state->only = paths;
  state->supervisor =
      std::jthread([s = state.get()](const std::stop_token& stop) { s->supervise(stop); });
  return InputDevices(std::move(state));
}

std::size_t InputDevices::arrived(std::span<InputEvent> out) noexcept {
  std::size_t count = 0;
  for (Slot& slot : state_->slots)
    while (count < out.size() && slot.queue.pop(out[count])) ++count;
  return count;
}

}  // namespace docent
