#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "runtime/model/result.h"
#include "runtime/release/device_state.h"
#include "runtime/release/health.h"
#include "runtime/release/manifest.h"

namespace docent::release {

/// What of a device matters to a release.
struct Device {
  std::string program{};     ///< Its version: "0.1.0".
  std::uint32_t schema = 0;  ///< Of the databases that it shows.
  std::string group{};       ///< May be empty.
};

enum class Answer : std::uint8_t {
  Take,        ///< Fetch it and show it.
  Current,     ///< It is shown already.
  NotYet,      ///< Its rollout has not come to this device.
  Stopped,     ///< Devices have gone back from it.
  WentBack,    ///< This device has gone back from it.
  OtherGroup,  ///< It is not for this device.
};

/// What to do about a manifest whose signature is right. An error is a refusal: an older release
/// than one that was seen (InvalidInput), one that has expired, one made after this machine's
/// `now`, one for newer programs alone. Whatever comes out, what is shown stays shown.
Result<Answer> decide(const Manifest& manifest, const std::optional<Health>& health,
                      const DeviceState& state, const Device& device, Time now);

/// The share of the rollout's time that has gone by: 0 to 1.
double elapsed_share(const Rollout& rollout, Time now) noexcept;

/// "0.10.2" is not older than "0.9". A version that is none is older than all others.
bool is_older(std::string_view version, std::string_view than);

}  // namespace docent::release
