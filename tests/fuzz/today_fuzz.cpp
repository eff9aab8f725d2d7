#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "config/today.h"
#include "platform/file/text_encoding.h"

using namespace docent;

namespace {

Museum small_museum() {
  Museum museum;
  museum.floors.emplace_back().plan.doors = {{.name = "gate", .a = {}, .b = {}}};
  museum.rooms.resize(1);
  museum.rooms[0].id = "hall";
  museum.exhibits.resize(1);
  museum.exhibits[0].id = "vase";
  museum.connections.resize(1);
  museum.connections[0].id = "lift";
  return museum;
}

}  // namespace

/// Any bytes are a today.toml that closes what there is, or are refused with a place and a
/// sentence; where the whole file is in another encoding or no text at all, the file is the place.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const Museum museum = small_museum();
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto today = config::parse_today(text, "today.toml", museum);
  if (today.value.has_value() != today.diagnostics.empty()) __builtin_trap();
  const std::optional<file::EncodingFault> fault = file::encoding_fault(text);
  const bool has_lines = !fault || fault->line > 0;
  for (const Diagnostic& diagnostic : today.diagnostics)
    if (diagnostic.message.empty() || (diagnostic.line > 0) != has_lines) __builtin_trap();
  if (today.value)
    for (const TodayClosure& closure : today.value->closed)
      if (closure.id != "gate" && closure.id != "hall" && closure.id != "vase" &&
          closure.id != "lift")
        __builtin_trap();
  return 0;
}
