#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/hours/opening_hours.h"
#include "runtime/model/local_text.h"

namespace docent {

/// What staff can close.
enum class Closable : std::uint8_t { Door, Room, Connection, Exhibit };

/// One thing that is closed just now.
struct TodayClosure {
  Closable what = Closable::Door;
  std::string id;
  std::optional<LocalMinute> until{};  ///< From then on it is open again; none: until staff say so.
  LocalText reason{};                  ///< May be empty.
  bool operator==(const TodayClosure&) const = default;
};

/// What staff close without a new compile: a today.toml.
struct Today {
  std::vector<TodayClosure> closed;
  bool operator==(const Today&) const = default;
};

}  // namespace docent
