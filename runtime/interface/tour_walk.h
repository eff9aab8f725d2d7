#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>

#include "runtime/model/museum.h"

namespace docent::interface {

/// Where a visitor is on a tour: on the way to one of its stops, or there.
struct TourWalk {
  std::uint32_t tour = 0;  ///< Index into Museum::tours.
  std::uint32_t stop = 0;  ///< Index into Tour::exhibits.

  bool operator==(const TourWalk&) const = default;
};

/// The tour that is walked; null where there is none, or no such stop.
inline const Tour* tour_of(const Museum& museum, const std::optional<TourWalk>& walk) noexcept {
  if (!walk || walk->tour >= museum.tours.size()) return nullptr;
  const Tour& tour = museum.tours[walk->tour];
  return walk->stop < tour.exhibits.size() ? &tour : nullptr;
}

/// The stop after this one, whether this one was seen or is skipped; none after the last.
inline std::optional<TourWalk> next_stop(const Museum& museum,
                                         const std::optional<TourWalk>& walk) noexcept {
  const Tour* tour = tour_of(museum, walk);
  if (tour == nullptr || walk->stop + 1 >= tour->exhibits.size()) return {};
  return TourWalk{walk->tour, walk->stop + 1};
}

/// How long the tour still takes: from the stop before to the end where the visitor is on the way
/// to a stop, from the first look at it where they have arrived. As if nothing is skipped from here
/// on; what was skipped before does not count.
inline double seconds_left(const Museum& museum, const std::optional<TourWalk>& walk,
                           bool has_arrived) noexcept {
  const Tour* tour = tour_of(museum, walk);
  if (tour == nullptr || tour->arrives.size() != tour->exhibits.size()) return 0;
  if (has_arrived) return tour->seconds - tour->arrives[walk->stop];
  if (walk->stop == 0) return tour->seconds;
  const std::size_t before = walk->stop - 1;
  const Exhibit& seen = museum.exhibits[tour->exhibits[before]];
  return tour->seconds - tour->arrives[before] - seen.looking_seconds;
}

}  // namespace docent::interface
