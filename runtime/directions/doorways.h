#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "runtime/model/museum.h"
#include "runtime/model/none.h"
#include "runtime/path/route.h"

namespace docent::directions {

/// A gap in a room's outline through which one can walk. Floor frame.
struct Doorway {
  Vec2 middle{};
  Vec2 outward{1, 0};           ///< Unit, out of the room.
  double width = 0;             ///< Metres.
  std::uint32_t beyond = none;  ///< Index into Museum::rooms; none: no named room within 2.5 m.

  /// Where rooms open into each other more widely, nobody speaks of a door.
  static constexpr double widest_door = 4;
  bool is_door() const noexcept { return width <= widest_door; }
};

/// The doorways of all rooms of a museum: those of one room after those of another.
struct Doorways {
  std::vector<std::uint32_t> first{0};  ///< One more than there are rooms.
  std::vector<Doorway> doorway;

  std::span<const Doorway> of(std::uint32_t room) const noexcept {
    if (room + 1 >= first.size()) return {};
    return std::span(doorway).subspan(first[room], first[room + 1] - first[room]);
  }
};

/// Finds them on the plans. A room without an outline has none. `maps`: one for each floor.
Doorways find_doorways(const Museum& museum,
                       std::span<const std::shared_ptr<const path::FloorMap>> maps);

/// A door that a way leads through.
struct PassedDoor {
  Vec2 middle{};
  Vec2 through{1, 0};  ///< Unit, as one walks.
  double width = 0;    ///< Metres.
  double along = 0;    ///< Metres from the way's beginning.
};

/// Those of a way along a floor, in its order; the two sides of one wall are one door.
std::vector<PassedDoor> doors_along(const Museum& museum, const Doorways& doorways,
                                    std::uint32_t floor, std::span<const Vec2> way);

}  // namespace docent::directions
