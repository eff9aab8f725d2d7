#include "config/weekly_hours.h"

#include <cstddef>
#include <cstdint>
#include <string_view>

using namespace docent;

/// Hours that can be read hold from the first minute of each of their spans to its last, and only
/// such spans are read as begin on their day and last at most one.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  constexpr std::int32_t day_minutes = 24 * 60;
  const auto hours = config::parse_weekly_hours({reinterpret_cast<const char*>(data), size});
  if (!hours) {
    if (hours.error().empty()) __builtin_trap();
    return 0;
  }
  for (int day = 0; day < 7; ++day)
    for (const auto& [begin, end] : hours->day[static_cast<std::size_t>(day)]) {
      if (begin < 0 || begin >= day_minutes || end <= begin || end - begin > day_minutes)
        __builtin_trap();
      if (!config::holds(*hours, day, begin)) __builtin_trap();
      const std::int32_t last = end - 1;
      if (!config::holds(*hours, day + last / day_minutes, last % day_minutes)) __builtin_trap();
    }
  return 0;
}
