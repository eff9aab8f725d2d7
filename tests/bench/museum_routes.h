#pragma once

#include <string>
#include <vector>

#include "runtime/model/museum.h"

namespace docent::bench {

/// Ways of one kind between the exhibits of a museum, with the corners that they have before a
/// guide's are rounded: harder to walk along.
struct MuseumRoutes {
  std::string name;
  std::vector<std::vector<Vec2>> path;
};

/// So many pairs of exhibits of one floor, the same in every run, once for each kind of way:
/// shortest, skeleton, offset.
std::vector<MuseumRoutes> museum_routes(const Museum& museum, std::size_t count = 24);

/// A path like stairs: steps of so many metres to the right and to the left in turn.
std::vector<Vec2> stairs_path(double step, std::size_t corners = 12);

/// Where the guide's head jumped: 4 m, a sharp corner, and back.
std::vector<Vec2> hairpin_path();

}  // namespace docent::bench
