#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/path/building/building_map.h"
#include "runtime/path/building/place_costs.h"

namespace docent::path {

/// How a tour is to be walked: from where, by a body of which radius, by which connections.
struct TourWish {
  BuildingPlace from;
  RouteQuery way{.tell_clearance = false};  ///< Of each part; its ends do not count.
  Permissions permissions{};
};

/// A tour of exhibits as it is walked.
struct MuseumTour {
  std::vector<std::uint32_t> exhibits;  ///< Indices into Museum::exhibits, in order.
  double walk_seconds = 0;              ///< At strolling_pace, with waits.
  double looking_seconds = 0;
  std::vector<double> arrives;  ///< Seconds from the start to each exhibit, looks included.
  double length = 0;            ///< Metres, over floors and stairs.
  bool optimal = false;         ///< Proved: no other order is shorter, or choice better.
  double weight = 0;            ///< Of the exhibits.
  double most_weight = 0;       ///< Of a choice: no other that there is time for weighs more.
  std::optional<BuildingStatus> why_not{};  ///< Else why there is no tour:
  std::vector<std::uint32_t> unreached;     ///< exhibits to which there is no way from the start.

  double seconds() const noexcept { return walk_seconds + looking_seconds; }
};

/// Which exhibits are visited first and last, as indices into Museum::exhibits.
struct ExhibitEnds {
  std::optional<std::uint32_t> first{}, last{};
};

/// The tour that visits the exhibits, each of them once, in the least time. `exhibits`: no index
/// twice; the ends are among them.
MuseumTour shortest_tour(const Museum& museum, const BuildingMap& building,
                         std::span<const std::uint32_t> exhibits, const ExhibitEnds& ends,
                         const TourWish& wish);

/// The tour that visits the exhibits in the order given.
MuseumTour tour_in_order(const Museum& museum, const BuildingMap& building,
                         std::span<const std::uint32_t> exhibits, const TourWish& wish);

/// The tour of the greatest weight, by the exhibits' weights, that is over in so many seconds,
/// looking included.
MuseumTour best_tour(const Museum& museum, const BuildingMap& building, double seconds,
                     const TourWish& wish);

/// From where the museum's kiosk stands, for its guide.
TourWish tour_from_kiosk(const Museum& museum);

/// Takes a tour as it was found to be walked.
void set_walk(Tour& tour, const MuseumTour& walked);

}  // namespace docent::path
