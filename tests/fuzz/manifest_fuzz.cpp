// Everything that docent-update reads of others, or of a disk that may be damaged: the manifest,
// health, its own state.

#include <cstddef>
#include <cstdint>
#include <string>

#include "runtime/release/device_state.h"
#include "runtime/release/health.h"
#include "runtime/release/manifest.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace docent::release;
  const std::string text(data, data + size);
  // What was understood is understood again from what is written of it.
  if (const auto manifest = parse_manifest(text, "fuzz"))
    if (parse_manifest(to_text(*manifest), "fuzz")->files != manifest->files) __builtin_trap();
  if (const auto state = parse_state(text, "fuzz"))
    if (parse_state(to_text(*state), "fuzz") != *state) __builtin_trap();
  if (const auto health = parse_health(text); health && health->back > health->taken)
    __builtin_trap();
  return 0;
}
