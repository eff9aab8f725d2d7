#include <cstddef>
#include <cstdint>
#include <span>

#include "runtime/input/hid_device_kind.h"

using namespace docent;

/// The first byte says how long the descriptor is; what follows it is fed to the decoders as
/// reports of 16 bytes.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size == 0) return 0;
  const auto bytes = std::as_bytes(std::span(data, size)).subspan(1);
  const std::size_t length = std::min<std::size_t>(data[0], bytes.size());
  const auto descriptor = input::parse_report_descriptor(bytes.first(length));
  if (!descriptor) return 0;
  const input::HidDeviceKind kind = input::classify(*descriptor);
  constexpr std::size_t report_size = 16;
  std::array<input::KeyEdge, 16> edges;
  input::KeyDecoder keys(*descriptor, kind.keys);
  for (auto rest = bytes.subspan(length); !rest.empty();
       rest = rest.subspan(std::min(report_size, rest.size())))
    keys.take(rest.first(std::min(report_size, rest.size())), edges);
  if (!kind.touch) return 0;
  input::ContactDecoder contacts(*descriptor, *kind.touch);
  for (auto rest = bytes.subspan(length); !rest.empty();
       rest = rest.subspan(std::min(report_size, rest.size())))
    contacts.take(rest.first(std::min(report_size, rest.size())));
  for (const input::Contact& contact : contacts.contacts())
    if (!(contact.x >= 0 && contact.x <= 1 && contact.y >= 0 && contact.y <= 1)) __builtin_trap();
  return 0;
}
