#pragma once

#include <array>
#include <chrono>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/hours/opening_hours.h"
#include "runtime/model/museum.h"
#include "runtime/model/today.h"

namespace docent {

/// An exhibit that cannot be seen, as visitors are told.
struct ClosedExhibit {
  std::uint32_t exhibit = 0;           ///< Index into Museum::exhibits.
  std::optional<LocalMinute> until{};  ///< None: nobody knows.
  LocalText reason{};                  ///< Empty where staff say none.

  bool operator==(const ClosedExhibit&) const = default;
};

/// What of a museum is closed at a moment: for good, by hours and live, all in one. Indices,
/// ascending. A closed room's doors and exhibits are closed with it.
struct Closures {
  /// By floor: indices into its plan's doors, without those that are walls of the plan already.
  std::vector<std::vector<std::uint32_t>> doors;
  std::vector<std::uint32_t> rooms, connections;
  std::vector<ClosedExhibit> exhibits;
  /// The moment's, where an exhibit opens again some day: "tomorrow" is told from it. None without
  /// a clock.
  std::optional<std::chrono::local_days> day{};

  bool operator==(const Closures&) const = default;
};

/// Null where the exhibit can be seen.
const ClosedExhibit* closed_exhibit(const Closures& closures, std::uint32_t exhibit) noexcept;

/// Until when something is closed, and why.
struct ClosedUntil {
  std::optional<LocalMinute> until;   ///< None: nobody knows.
  const LocalText* reason = nullptr;  ///< Null where staff say none. Of the Today that was asked.
};

/// Says what is closed when. Immutable; any thread may ask. Borrows the museum.
class ClosureRules {
 public:
  explicit ClosureRules(const Museum& museum);

  /// `at`: in the museum's time; none: what hours close is open, and what is closed live is closed.
  Closures at(std::optional<LocalMinute> at, const Today& today) const;

  /// None where the exhibit can be seen. `at`: as above.
  std::optional<ClosedUntil> exhibit(std::uint32_t exhibit, std::optional<LocalMinute> at,
                                     const Today& today) const;

  /// The rooms on the two sides of a door; `none` where there is none.
  struct Sides {
    std::array<std::uint32_t, 2> room;
  };

 private:
  struct Part {
    Closable what{};
    const std::string* id = nullptr;
    bool closed = false;                ///< For good.
    std::optional<OpeningHours> hours;  ///< None: always open.
  };
  template <typename T>
  static Part part(Closable what, const std::string& id, const T& thing);
  std::optional<ClosedUntil> state(const Part& part, std::optional<LocalMinute> at,
                                   const Today& today) const;
  std::vector<std::uint32_t> closed_of(std::span<const Part> parts, std::optional<LocalMinute> at,
                                       const Today& today) const;

  const Museum& museum_;
  std::vector<DateRange> holidays_;
  std::vector<std::vector<Part>> doors_;   ///< By floor.
  std::vector<std::vector<Sides>> sides_;  ///< Of the doors.
  std::vector<Part> rooms_, connections_, exhibits_;
};

/// The rooms on the two sides of a door of a floor: the first whose outline one comes to, going
/// straight away from the door's middle, within a metre.
ClosureRules::Sides rooms_beside(const Museum& museum, std::uint32_t floor, const Door& door);

}  // namespace docent
