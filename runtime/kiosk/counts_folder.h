#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/kiosk/daily_counts.h"
#include "runtime/model/result.h"

namespace docent::kiosk {

/// Days that are over, of this many days before now, are kept; older ones are removed.
inline constexpr int days_kept = 400;

/// Where a kiosk keeps its counts: `DAY.csv` of each day that is over, for everybody to read, and
/// `open`, the day that is going on, for the kiosk's user alone.
///
/// A day is published once, when it is over; what is published does not change any more, whatever
/// the clock does. A clock that is set back gives the open day its new date; counts of a day that
/// has been published already are dropped when it ends.
class CountsFolder {
 public:
  /// Goes on with the open day that the folder holds; an unreadable one is begun anew.
  explicit CountsFolder(std::filesystem::path folder);

  /// Adds what was counted up to now. `today`: "2026-11-23". What cannot be written is kept and
  /// tried again with the next call; the error says why.
  Result<void> take(std::string_view today, const DailyCounts& more);

  const DailyCounts& open_day() const noexcept { return open_; }
  /// The last day that was published by this kiosk's clock; empty where there is none.
  const std::optional<PublishedCounts>& last_day() const noexcept { return last_; }

 private:
  Result<void> close_day(std::string_view today);

  std::filesystem::path folder_;
  DailyCounts open_, written_;
  std::optional<PublishedCounts> last_;
};

/// All that a folder tells to everybody, as one CSV, day by day. Fails where it is none.
Result<std::string> published_csv(const std::filesystem::path& folder);

/// What lines of a published day say; empty for other text.
std::optional<PublishedCounts> published_counts_from(std::string_view text);

/// "2026-11-23" at this place on earth.
std::string today();

/// Who may read a file.
enum class Readers : std::uint8_t { Everybody, Owner };
/// Writes a file whole or not at all, whatever the process's mask of permissions.
Result<void> replace_text(const std::filesystem::path& file, std::string_view text,
                          Readers readers);

}  // namespace docent::kiosk
