#include "runtime/release/health.h"

#include "runtime/release/words.h"

namespace docent::release {

std::optional<Health> parse_health(std::string_view text) {
  const auto lines = lines_of(text);
  if (lines.size() != 2 || lines[0] != std::vector<std::string_view>{"docent", "health", "1"})
    return std::nullopt;
  const auto& words = lines[1];
  if (words.size() != 6 || words[0] != "release" || words[2] != "taken" || words[4] != "back")
    return std::nullopt;
  const auto version = number_of(words[1]), taken = number_of(words[3]), back = number_of(words[5]);
  if (!version || !taken || !back || *back > *taken) return std::nullopt;
  return Health{.version = *version, .taken = *taken, .back = *back};
}

bool is_stopped(const Health& health, std::uint64_t version) noexcept {
  constexpr std::uint64_t one_in = 50, least = 2;
  return health.version == version && health.back >= least && health.back >= health.taken / one_in;
}

}  // namespace docent::release
