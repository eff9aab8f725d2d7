#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <span>
#include <utility>
#include <vector>

#include "runtime/input/hid_device_kind.h"

using namespace docent;

namespace {

using Bytes = std::span<const std::byte>;

/// Takes so many bytes from the front, or what is left.
Bytes take(Bytes& from, std::size_t count) {
  const Bytes taken = from.first(std::min(count, from.size()));
  from = from.subspan(taken.size());
  return taken;
}

std::size_t number(Bytes& from, std::size_t size) {
  std::size_t value = 0;
  std::size_t place = 1;
  for (const std::byte byte : take(from, size)) {
    value += std::to_integer<std::size_t>(byte) * place;
    place *= 256;
  }
  return value;
}

/// The fingers that a guide believes to be down, from events alone; they must be the decoder's.
class Glass {
 public:
  void follow(std::span<const input::Contact> contacts) {
    std::array<input::InputEvent, 2 * input::max_contacts> events;
    const std::size_t count = input::contact_events(before_, contacts, events);
    for (const input::InputEvent& event : std::span(events).first(count)) apply(event);
    std::set<std::uint32_t> now;
    for (const input::Contact& contact : contacts) {
      if (!(contact.x >= 0 && contact.x <= 1 && contact.y >= 0 && contact.y <= 1)) __builtin_trap();
      if (!now.insert(contact.id).second) __builtin_trap();
    }
    if (now != down_) __builtin_trap();
    before_.assign(contacts.begin(), contacts.end());
  }

 private:
  void apply(const input::InputEvent& event) {
    using Kind = input::InputEvent::Kind;
    const std::uint32_t id = event.contact.id;
    if (event.kind == Kind::Down && !down_.insert(id).second) __builtin_trap();
    if (event.kind == Kind::Move && !down_.contains(id)) __builtin_trap();
    if ((event.kind == Kind::Up || event.kind == Kind::Cancel) && down_.erase(id) != 1)
      __builtin_trap();
  }

  std::vector<input::Contact> before_;
  std::set<std::uint32_t> down_;
};

void apply(std::span<const input::KeyEdge> edges, std::set<std::pair<input::Key, char>>& down) {
  for (const input::KeyEdge& edge : edges) {
    const std::pair key{edge.key.key, edge.key.character};
    if (edge.key.key == input::Key::None) __builtin_trap();
    if (edge.down ? !down.insert(key).second : down.erase(key) != 1) __builtin_trap();
  }
}

}  // namespace

/// A device and what it sends: two bytes of length and the report descriptor; then the reports,
/// each after a byte of length; 255 is the device being unplugged. A finger that a guide has seen
/// go down is lifted once, and when the device has gone nothing is left down.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Bytes rest = std::as_bytes(std::span(data, size));
  const std::size_t length = number(rest, 2);
  const auto descriptor = input::parse_report_descriptor(take(rest, length));
  if (!descriptor) return 0;
  const input::HidDeviceKind kind = input::classify(*descriptor);
  if (!kind.touch && kind.keys.empty() && kind.ignored.empty()) __builtin_trap();
  input::KeyDecoder keys(*descriptor, kind.keys);
  std::optional<input::ContactDecoder> touch;
  if (kind.touch) touch.emplace(*descriptor, *kind.touch);
  // More than a report of 254 bytes can name, and all the keys that can be down.
  std::array<input::KeyEdge, 4096> edges;
  std::set<std::pair<input::Key, char>> keys_down;
  Glass glass;
  const auto unplug = [&] {
    apply(std::span(edges).first(keys.release(edges)), keys_down);
    if (!keys_down.empty()) __builtin_trap();
    if (touch) touch->reset();
    glass.follow({});
    if (touch && !touch->contacts().empty()) __builtin_trap();
  };
  while (!rest.empty()) {
    const std::size_t report_size = number(rest, 1);
    if (report_size == 255) {
      unplug();
      continue;
    }
    const Bytes report = take(rest, report_size);
    apply(std::span(edges).first(keys.take(report, edges)), keys_down);
    if (touch && touch->take(report)) glass.follow(touch->contacts());
  }
  unplug();
  return 0;
}
