#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "runtime/interface/own_tour.h"
#include "runtime/model/museum.h"

namespace docent::interface {

/// Where a visitor is on a tour: on the way to one of its stops, or there.
struct TourWalk {
  static constexpr std::uint32_t own = 0xFFFFFFFF;  ///< The tour that the visitor put together.

  std::uint32_t tour = 0;  ///< Index into Museum::tours, or `own`.
  std::uint32_t stop = 0;  ///< Index into the tour's exhibits.

  bool operator==(const TourWalk&) const = default;
};

/// How many tours there are for who has so much time, and how many others, which come before them.
inline std::uint32_t tours_for_time(const Museum& museum) noexcept {
  return static_cast<std::uint32_t>(std::ranges::count_if(museum.tours, is_for_time));
}
inline std::uint32_t tours_of_staff(const Museum& museum) noexcept {
  return static_cast<std::uint32_t>(museum.tours.size()) - tours_for_time(museum);
}

/// A tour as it is walked, whoever put it together. Borrowed.
struct TourStops {
  std::span<const std::uint32_t> exhibits;
  std::span<const double> arrives;  ///< As Tour's; empty while they are not known.
  double seconds = 0;
};

/// The tour that is walked; none where there is none, or no such stop.
inline std::optional<TourStops> stops_of(const Museum& museum, const OwnTour& own,
                                         const std::optional<TourWalk>& walk) noexcept {
  if (!walk) return {};
  TourStops stops;
  if (walk->tour == TourWalk::own) {
    stops = {own.exhibits(), {}, own.seconds};
    if (own.is_ordered) stops.arrives = std::span(own.arrives).first(own.count);
  } else if (walk->tour < museum.tours.size()) {
    const Tour& tour = museum.tours[walk->tour];
    stops = {tour.exhibits, tour.arrives, tour.seconds};
  }
  if (walk->stop >= stops.exhibits.size()) return {};
  return stops;
}

/// The stop after this one, whether this one was seen or is skipped; none after the last.
inline std::optional<TourWalk> next_stop(const Museum& museum, const OwnTour& own,
                                         const std::optional<TourWalk>& walk) noexcept {
  const std::optional<TourStops> tour = stops_of(museum, own, walk);
  if (!tour || walk->stop + 1 >= tour->exhibits.size()) return {};
  return TourWalk{walk->tour, walk->stop + 1};
}

/// How long the tour still takes: from the stop before to the end where the visitor is on the way
/// to a stop, from the first look at it where they have arrived. As if nothing is skipped from here
/// on; what was skipped before does not count. 0 where nobody knows.
inline double seconds_left(const Museum& museum, const OwnTour& own,
                           const std::optional<TourWalk>& walk, bool has_arrived) noexcept {
  const std::optional<TourStops> tour = stops_of(museum, own, walk);
  if (!tour || tour->arrives.size() != tour->exhibits.size()) return 0;
  if (has_arrived) return tour->seconds - tour->arrives[walk->stop];
  if (walk->stop == 0) return tour->seconds;
  const std::size_t before = walk->stop - 1;
  const Exhibit& seen = museum.exhibits[tour->exhibits[before]];
  return tour->seconds - tour->arrives[before] - seen.looking_seconds;
}

}  // namespace docent::interface
