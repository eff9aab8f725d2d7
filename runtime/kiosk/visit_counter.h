#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "runtime/guide/guide.h"
#include "runtime/kiosk/daily_counts.h"

namespace docent::kiosk {

/// What visits add up to, an entry for each of VisitCounter::cells().
struct VisitTally {
  std::uint64_t touches = 0;
  std::vector<std::uint64_t> visits;
};

/// Watches a guide's screens and counts what visitors do, as nobody's: of a visit under way it
/// knows which exhibits were asked for, by which kinds of way, and the language; when it ends, each
/// of those is counted once, and the visit is forgotten.
///
/// Frame thread; follow() does not allocate.
class VisitCounter {
 public:
  explicit VisitCounter(const guide::Guide& guide);

  /// Called after each step.
  void follow(const guide::Guide& guide) noexcept;
  /// What was counted since it was last cleared by its taker.
  VisitTally& tally() noexcept { return tally_; }
  /// What the tally's entries are of.
  const std::vector<CountedCell>& cells() const noexcept { return cells_; }

 private:
  struct UnderWay {
    bool is_there = false;
    std::uint32_t language = 0;
    std::vector<std::uint8_t> does;  ///< By cell: whether this visit belongs to it.
  };
  void follow(const interface::InterfaceState& state, UnderWay& visit) noexcept;
  void end(UnderWay& visit) noexcept;

  std::size_t exhibits_ = 0;  ///< Cells of exhibits come first, then kinds of way, then languages.
  std::vector<CountedCell> cells_;
  std::vector<UnderWay> visits_;  ///< By part of the glass.
  std::uint64_t touches_ = 0;
  VisitTally tally_;
};

/// A tally with its cells' names.
DailyCounts counts_of(const VisitTally& tally, const std::vector<CountedCell>& cells);

}  // namespace docent::kiosk
