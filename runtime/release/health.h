#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace docent::release {

/// What a release's health document is called beside its manifest. It may be missing.
inline constexpr std::string_view health_name = "health.txt";

/// How devices fare with a release, counted by whoever publishes it, out of what devices report. It
/// is not signed: whoever alters it can only stop a rollout, as can whoever cuts a cable.
///
///   docent health 1
///   release 42 taken 512 back 3
struct Health {
  std::uint64_t version = 0;
  std::uint64_t taken = 0;  ///< Devices that have taken it,
  std::uint64_t back = 0;   ///< and how many of these have gone back from it.
};

/// Safe on any bytes; nothing where they are no health.
std::optional<Health> parse_health(std::string_view text);

/// At 2 % that went back, and at least two devices, a release stops itself.
bool is_stopped(const Health& health, std::uint64_t version) noexcept;

}  // namespace docent::release
