#include <cstddef>
#include <cstdint>
#include <set>
#include <span>

#include "runtime/input/event_maker.h"
#include "runtime/input/keypad_policy.h"

using namespace docent;

namespace {

constexpr std::size_t report_size = 16;

/// Downs and ups of every finger alternate, and all lie on the glass.
void check(std::span<const input::InputEvent> events, std::set<std::uint32_t>& down) {
  using Kind = input::InputEvent::Kind;
  for (const input::InputEvent& event : events) {
    const input::Contact& c = event.contact;
    if (!(c.x >= 0 && c.x <= 1 && c.y >= 0 && c.y <= 1)) __builtin_trap();
    if (event.kind == Kind::Down && !down.insert(c.id).second) __builtin_trap();
    if (event.kind == Kind::Move && !down.contains(c.id)) __builtin_trap();
    if ((event.kind == Kind::Up || event.kind == Kind::Cancel) && down.erase(c.id) == 0)
      __builtin_trap();
  }
}

}  // namespace

/// The first byte says how long the descriptor is; what follows it is fed to the decoders as
/// reports of 16 bytes, each a while after the one before.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
  const std::size_t length = std::min<std::size_t>(data[0], bytes.size());
  const auto descriptor = input::parse_report_descriptor(bytes.first(length));
  if (!descriptor) return 0;
  const auto quirks = input::known_quirks();
  const input::TouchQuirk& quirk = quirks[data[0] % quirks.size()];
  for (const input::HidDeviceId id :
       {input::HidDeviceId{}, input::HidDeviceId{quirk.vendor, quirk.product}}) {
    const input::HidDeviceKind kind = input::classify(*descriptor, id);
    input::has_all_letters(kind.keys);
    input::EventMaker maker(*descriptor, kind, 1U << 20U);
    std::set<std::uint32_t> down;
    std::chrono::nanoseconds time{0};
    for (auto rest = bytes.subspan(length); !rest.empty();
         rest = rest.subspan(std::min(report_size, rest.size()))) {
      const auto report = rest.first(std::min(report_size, rest.size()));
      const auto last = std::to_integer<std::uint8_t>(report.back());
      time += std::chrono::milliseconds(last * 4);
      check(maker.wait(time), down);
      check(maker.take(
                report, time,
                last % 2 == 0 ? input::EventMaker::Moves::All : input::EventMaker::Moves::Later),
            down);
    }
    check(maker.lift_all(), down);
    if (!down.empty()) __builtin_trap();
  }
  return 0;
}
