#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/input/calibration.h"

using namespace docent;

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto read = input::parse_calibration(text, "fuzz");
  if (!read) return 0;
  if (!input::is_plausible(*read)) __builtin_trap();
  const auto again = input::parse_calibration(input::to_text(*read), "fuzz");
  for (const float at : {0.F, 0.5F, 1.F}) {
    const input::Contact contact = input::calibrated(*read, {1, at, 1 - at});
    if (!(contact.x >= 0 && contact.x <= 1 && contact.y >= 0 && contact.y <= 1)) __builtin_trap();
  }
  // A calibration at the very limit may fall beyond it when nine figures round it.
  if (again && !input::is_plausible(*again)) __builtin_trap();
  return 0;
}
