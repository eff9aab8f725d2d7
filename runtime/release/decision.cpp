#include "runtime/release/decision.h"

#include <fmt/format.h>

#include <algorithm>

namespace docent::release {
namespace {

/// A manifest may be a little younger than a clock that is a little slow.
constexpr Time slow_clock = 300;

template <typename... Values>
std::unexpected<Error> refused(fmt::format_string<Values...> sentence, Values&&... values) {
  return std::unexpected(
      Error{Errc::InvalidInput, fmt::format(sentence, std::forward<Values>(values)...)});
}

bool holds(const auto& list, const auto& value) {
  return std::ranges::find(list, value) != list.end();
}

/// What an attacker between the server and the device could try with manifests that once were
/// right: an old one (rollback), one for ever (freeze). Mix and match is what the hashes are for.
Result<void> check_freshness(const Manifest& manifest, const DeviceState& state, Time now) {
  if (manifest.version < state.seen)
    return refused("release {} is older than release {}, which was seen before; it is not taken",
                   manifest.version, state.seen);
  if (manifest.version == state.seen && manifest.issued < state.seen_issued)
    return refused("the manifest of release {} is older than the one seen before; it is not taken",
                   manifest.version);
  if (now + slow_clock < manifest.issued)
    return refused(
        "release {} was made on {}, and this machine's clock says {}; nothing is taken until its "
        "clock is right",
        manifest.version, text_of(manifest.issued), text_of(now));
  if (now > manifest.expires)
    return refused(
        "release {} expired on {}, and this machine's clock says {}; publish it again, or set the "
        "clock",
        manifest.version, text_of(manifest.expires), text_of(now));
  return {};
}

}  // namespace

Result<Answer> decide(const Manifest& manifest, const std::optional<Health>& health,
                      const DeviceState& state, const Device& device, Time now) {
  if (const Result<void> fresh = check_freshness(manifest, state, now); !fresh)
    return std::unexpected(fresh.error());
  if (!manifest.groups.empty() && !holds(manifest.groups, device.group)) return Answer::OtherGroup;
  if (state.shown == manifest.version) return Answer::Current;
  if (holds(state.refused, manifest.version)) return Answer::WentBack;
  if (holds(manifest.halted, manifest.version)) return Answer::Stopped;
  if (!manifest.program.empty() && is_older(device.program, manifest.program))
    return refused("release {} is for docent {} and newer, and this is {}; update the program",
                   manifest.version, manifest.program, device.program);
  if (file_for(manifest, device.schema) == nullptr)
    return refused(
        "release {} holds no database of schema version {}, which this program shows; publish one",
        manifest.version, device.schema);
  // Whoever shows what was withdrawn does not wait for its turn.
  if (holds(manifest.halted, state.shown)) return Answer::Take;
  if (health && is_stopped(*health, manifest.version)) return Answer::Stopped;
  if (state.shown == 0) return Answer::Take;  // a new device has nothing to be careful with
  return state.portion < elapsed_share(manifest.rollout, now) ? Answer::Take : Answer::NotYet;
}

double elapsed_share(const Rollout& rollout, Time now) noexcept {
  if (rollout.hours == 0) return 1;
  const double elapsed = static_cast<double>(now - rollout.start);
  return std::clamp(elapsed / (static_cast<double>(rollout.hours) * 3600), 0.0, 1.0);
}

bool is_older(std::string_view version, std::string_view than) {
  const auto next = [](std::string_view& text) {
    const std::size_t dot = std::min(text.find('.'), text.size());
    const auto number = number_of(text.substr(0, dot));
    text.remove_prefix(std::min(dot + 1, text.size()));
    return number.value_or(0);
  };
  while (!version.empty() || !than.empty()) {
    const std::uint64_t a = next(version), b = next(than);
    if (a != b) return a < b;
  }
  return false;
}

}  // namespace docent::release
