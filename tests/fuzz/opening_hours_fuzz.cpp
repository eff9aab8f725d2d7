#include "runtime/model/hours/opening_hours.h"

#include <chrono>
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "runtime/model/hours/time_zone.h"

using namespace docent;

/// Hours that can be read hold spans of a day at most, and change when they say that they do; what
/// cannot be read says where. Any bytes are a time zone or none.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  (void)parse_time_zone(text);
  (void)parse_dates(text);
  const auto hours = parse_opening_hours(text);
  if (!hours) {
    const HoursError& error = hours.error();
    if (error.what.empty() || error.hint.empty() || error.column > size + 1) __builtin_trap();
    return 0;
  }
  for (const OpeningHours::Rule& rule : hours->rules)
    for (const auto& [begin, end] : rule.spans)
      if (begin < 0 || begin >= 24 * 60 || end <= begin || end > begin + 24 * 60) __builtin_trap();
  if (hours->rules.size() > 20) return 0;  // slow, and nothing new
  using namespace std::chrono;
  const LocalMinute at = local_days(year(2026) / November / 23) + minutes(600);
  const auto change = next_change(*hours, {}, at);
  if (change && is_open(*hours, {}, *change) == is_open(*hours, {}, at)) __builtin_trap();
  return 0;
}
