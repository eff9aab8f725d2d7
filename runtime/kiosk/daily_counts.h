#pragma once

#include <compare>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace docent::kiosk {

/// A cell of fewer visits than this is given to nobody: it might tell of one person.
inline constexpr std::uint64_t least_published = 5;

/// What a count is of. A visit counts once in each cell that it belongs to, however often it did
/// what the cell counts; so a cell of five tells of five visits.
struct CountedCell {
  enum class Kind : std::uint8_t { Exhibit, Route, Language };
  Kind kind = Kind::Exhibit;
  std::string name;  ///< The exhibit's id, the route kind's name, the language's tag.

  auto operator<=>(const CountedCell&) const = default;
};
using CellCounts = std::map<CountedCell, std::uint64_t>;

/// One day's counts of one kiosk, while it is going on: the small cells are in it, so it stays with
/// the kiosk.
struct DailyCounts {
  std::string day;  ///< "2026-11-23", as the kiosk's clock says. Empty: no day yet.
  std::uint64_t touches = 0;
  CellCounts visits;  ///< Every visit is in exactly one cell of its language.

  bool operator==(const DailyCounts&) const = default;
};

/// Adds what happened. The day stays.
DailyCounts& operator+=(DailyCounts& counts, const DailyCounts& more);

/// What everybody may know of a day that is over.
///
/// Whether a cell is in it depends on the cells of at least `least_published` alone, and `visits`
/// is the sum of the language cells that are in it. Where the cells of one kind would tell of the
/// small ones of another (twenty were led, and none of the five exhibits was asked for five times:
/// so each four times), only languages are told. So all that is known of a cell left out is that it
/// is less than `least_published`: no sum, no difference and no other day gives more.
struct PublishedCounts {
  std::string day;
  std::uint64_t visits = 0;   ///< In languages of at least `least_published` visits.
  std::uint64_t touches = 0;  ///< 0 where `visits` is.
  CellCounts cells;

  bool operator==(const PublishedCounts&) const = default;
};
PublishedCounts published(const DailyCounts& counts);

/// A line a number, `day,kind,name,count`, without the header: kinds are visits, touches, exhibit,
/// route and language.
inline constexpr std::string_view counts_header = "day,kind,name,count\n";
std::string to_csv(const PublishedCounts& counts);

/// The day that is going on, as the kiosk keeps it for its next start; empty for any other text.
std::string to_text(const DailyCounts& counts);
std::optional<DailyCounts> daily_counts_from(std::string_view text);

/// "exhibit", "route", "language".
std::string_view to_string(CountedCell::Kind kind) noexcept;

}  // namespace docent::kiosk
