#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "config/museum_config.h"
#include "content/floor/footprint.h"
#include "content/import/floor/imported_plan.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/path/index/wall_grid.h"

namespace docent::compile {

/// A case or an exhibit, as staff put it on a floor.
struct Standing {
  enum class Kind : std::uint8_t { Case, Exhibit };
  Kind kind = Kind::Exhibit;
  std::size_t index = 0;  ///< Into the config's cases or exhibits.
  std::string name;       ///< "exhibit 'tripod-ding'".
  floor::Footprint footprint;
  /// Of an exhibit: what it stands on; empty while that is not known, and where it is nothing.
  std::optional<ExhibitPlace> place;
};

/// Does it take a part of the floor? Cases do, and exhibits that stand free: not what hangs on a
/// wall or stands in a case, which takes its own floor, and nothing of size 0.
bool takes_floor(const Standing& thing);

/// The cases and exhibits of a floor whose position staff gave, in the order of their files.
std::vector<Standing> standing_on(const config::MuseumConfig& config, std::size_t floor);

/// What a point of a floor has under it; empty outside of the building. `walls` are those without
/// what stands free, `drawn` the plan with its holes, for those that mending joined to a wall, and
/// `cases` what staff added to it.
std::optional<ExhibitPlace> what_it_stands_on(const path::WallGrid& walls,
                                              std::span<const import::ImportedPolygon> drawn,
                                              std::span<const floor::Footprint> cases, Vec2 point);

/// Two things that take the same part of a floor, and by how much, metres.
struct Overlap {
  const Standing* first = nullptr;
  const Standing* second = nullptr;  ///< Written after the first.
  double depth = 0;
};
/// At most one for each thing: with the first of those before it.
std::vector<Overlap> overlaps_of(std::span<const Standing> things);

/// Where staff wrote where it stands.
const config::Place& place_of_position(const config::MuseumConfig& config, const Standing& thing);

/// "0.60 by 0.40 m"
std::string size_text(const floor::Footprint& footprint);

}  // namespace docent::compile
