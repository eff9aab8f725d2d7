#pragma once

#include <cstdint>
#include <expected>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/diagnostic.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::import {

/// Where something stood in a source, for the sentence that tells its author about it.
struct Placed {
  std::string file{};        ///< As the author named it.
  std::uint32_t line = 0;    ///< From 1; 0 where it is not known.
  std::uint32_t column = 0;  ///< From 1; 0 where it is not known.
};

/// Titles by language tag.
using Titles = std::map<std::string, std::string>;

/// A closed ring in metres, the first vertex not repeated; either way round.
using BuildingRing = std::vector<Vec2>;

/// One room, corridor or open area of a level.
struct ImportedRoom {
  std::string name{};  ///< As the plan says it; may be empty.
  Titles titles{};     ///< The same by language, where the plan knows languages.
  std::string kind{};  ///< `room`, `corridor`, `hall` (an open area); empty is `room`.
  std::vector<BuildingRing> rings{};  ///< The outer one first, then holes.
  /// Square metres, as the source itself says: net of low eaves, or with half the walls. Its
  /// outline may have others.
  std::optional<double> stated_area{};
  std::string source_id{};  ///< What the source calls it: `way/-23`; stable from file to file.
  Placed place{};
};

/// An opening in a wall, from one jamb to the other.
struct ImportedDoor {
  std::string id{};
  Vec2 a{}, b{};     ///< The two jambs. Where they coincide, the wall there says which way it runs.
  double width = 0;  ///< Metres; 0 where the source says nothing.
  bool doubtful = false;  ///< Found, not stated.
  std::string source_id{};
};

/// Something that visitors ask for: `toilets`, `information`, by the standard list of kinds.
struct ImportedPlace {
  std::string kind{}, name{};
  Titles titles{};
  Vec2 position{};
};

/// Stairs or a lift as one level's plan shows them; which other levels they lead to it does not
/// say.
struct ImportedShaft {
  std::string kind{};  ///< As config::connection_kinds.
  std::string name{};
  Vec2 position{};
};

struct ImportedLevel {
  std::string name{};  ///< `ground`, `0`, `Level 1`; what --level and connections call it.
  Titles titles{};
  std::string short_name{};           ///< `G`; may be empty.
  double ordinal = 0;                 ///< 0 on the ground.
  bool unsaid = false;                ///< The source does not say which level this is.
  std::optional<double> elevation{};  ///< Metres.
  std::vector<ImportedRoom> rooms{};
  std::vector<ImportedDoor> doors{};
  std::vector<ImportedPlace> places{};
  /// Lines along which one walks: where one leads through a wall, it is open.
  std::vector<std::vector<Vec2>> ways{};
  std::vector<ImportedShaft> shafts{};
  std::vector<BuildingRing> obstacles{};  ///< Columns, fixtures, drawn walls: nobody walks there.
};

/// Where a connection meets a level.
struct ImportedStop {
  std::string level{};  ///< ImportedLevel::name.
  Vec2 position{};
  double facing = 0;  ///< Radians counter-clockwise from east.
};

/// Stairs, an escalator, a lift or a ramp.
struct ImportedConnection {
  std::string kind{};                 ///< As config::connection_kinds.
  std::vector<ImportedStop> stops{};  ///< Two or more, each on another level.
  std::string direction{};            ///< As config::connection_directions; empty is both.
  std::string name{}, source_id{};
};

/// What the reader is not sure of, and what one line of the staff's would settle.
struct Doubt {
  std::string code{}, level{};
  Vec2 at{};
  std::string message{}, hint{};
};

/// A building as one or several files say it, all levels in one frame. Frame: floor (metres, x
/// east, y north), the same for all levels.
struct ImportedBuilding {
  std::vector<ImportedLevel> levels{};
  std::vector<ImportedConnection> connections{};
  std::vector<Doubt> doubts{};
  std::string unit_said{};       ///< How the unit was found: `stated: millimetres`.
  std::string frame_said{};      ///< How the frame was found: `longitude and latitude about ...`.
  std::string attribution{};     ///< Whom the data's licence asks to name; may be empty.
  std::optional<Vec2> origin{};  ///< Degrees, longitude and latitude, of (0, 0).
  /// Of a drawing: what was taken off its positions. Metres.
  std::optional<Vec2> moved_by{};
};

/// A file in memory, whatever it holds.
struct BuildingSource {
  std::string file{};   ///< As the author named it.
  std::string bytes{};  ///< All of it.
  std::string level{};  ///< What `--level NAME=FILE` says of it; may be empty.
};

/// What the command line says that files may not.
struct ImportOptions {
  std::string unit{};             ///< As metres_of() knows them; empty: as the file says.
  std::optional<Vec2> origin{};   ///< Degrees, longitude and latitude, that become (0, 0).
  std::optional<Vec2> move_by{};  ///< ImportedBuilding::moved_by of the museum's drawing before.
  std::map<std::string, std::string> layers{};  ///< Layer's name by kind: `walls` = `A-WALL`.
};

using Diagnostics = std::vector<Diagnostic>;

/// What a reader gives: a building, or every mistake that was found. A reader may also throw
/// content::ContentError.
using BuildingOrDiagnostics = std::expected<ImportedBuilding, Diagnostics>;

}  // namespace docent::import
