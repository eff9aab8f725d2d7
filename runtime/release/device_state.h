#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/result.h"
#include "runtime/release/words.h"

namespace docent::release {

/// A release that a device keeps: a file of its store.
struct Kept {
  std::uint64_t version = 0;
  std::uint32_t schema = 0;
  std::string hash{};
  bool operator==(const Kept&) const = default;
};

/// What a device remembers of releases. The whole of it is written before anything that is shown is
/// changed, so a power cut finds either the old intent or the new one.
struct DeviceState {
  double portion = 0;      ///< In [0, 1), made once: its place in every rollout.
  std::uint64_t seen = 0;  ///< The newest release that was ever accepted; older ones are refused.
  Time seen_issued = 0;    ///< When that manifest was made.
  std::uint64_t shown =
      0;  ///< The release whose database is shown; 0: one that was copied by hand.
  std::uint32_t shown_schema = 0;
  bool is_pending = false;               ///< `shown` may not have come to its place yet.
  Time shown_since = 0;                  ///< When it was installed.
  std::vector<Time> starts{};            ///< Of the kiosk, since then.
  std::vector<std::uint64_t> refused{};  ///< Releases that were gone back from: not taken again.
  std::vector<Kept> kept{};
  std::string etag{};  ///< Of the manifest that was last decided on for good, for conditional GET.
  bool operator==(const DeviceState&) const = default;
};

std::string to_text(const DeviceState& state);
/// Safe on any bytes; Damaged where they are no state.
Result<DeviceState> parse_state(std::string_view text, const std::filesystem::path& file);

/// A kiosk that is started for the third time within ten minutes of an update is better off without
/// it. Notes a start at `now` and says whether it is that one.
bool note_start(DeviceState& state, Time now);

/// The newest kept release that `schema` programs can show, older than the one shown and not gone
/// back from; null where there is none.
const Kept* one_before(const DeviceState& state, std::uint32_t schema);
/// The newest kept of that schema that was not gone back from.
const Kept* newest_kept(const DeviceState& state, std::uint32_t schema);

}  // namespace docent::release
