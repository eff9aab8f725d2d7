#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "content/import/building/imported_building.h"

namespace docent::import {

/// What a drawn thing is in a building.
enum class FeatureRole : std::uint8_t {
  Other,     ///< Nothing that a plan of rooms needs, unless it is a place or a connection.
  Room,      ///< Walls all round.
  Corridor,  ///< Walls towards rooms, none towards corridors and halls.
  Hall,      ///< An open area: walls only where a neighbour has them.
  Wall,
  Obstacle,
  Door,
  Way,      ///< A line along which one walks.
  Outline,  ///< A whole level's; tells its name.
};

enum class FeatureForm : std::uint8_t { Point, Line, Area };

/// One drawn thing, in metres: what readers of maps make of their formats, and `assemble` makes a
/// building of.
struct PlanFeature {
  FeatureRole role = FeatureRole::Other;
  FeatureForm form = FeatureForm::Point;
  std::vector<Vec2> line{};                           ///< Of a Line; of a Point its one point.
  std::vector<std::vector<BuildingRing>> polygons{};  ///< Of an Area: outer rings with holes.
  std::vector<double> levels{};  ///< Ordinals, rising. Empty where nothing is said.
  std::string name{}, source_id{}, short_name{};
  Titles titles{};
  std::string connection{};           ///< As config::connection_kinds; empty where it is none.
  std::string direction{};            ///< Along the line: `forward`, `backward`; empty is both.
  std::optional<bool> up{};           ///< Does the line lead up?
  std::vector<std::string> places{};  ///< Kinds, as in museum.toml.
  double width = 0;                   ///< Metres; 0 where it is not said.
  std::string from{}, to{};  ///< Of a door: names of the rooms that it joins; may be empty.
  Placed placed{};
};

/// What is known of levels besides the features on them.
struct LevelFact {
  double ordinal = 0;
  std::string name{}, short_name{};
  Titles titles{};
  std::optional<double> elevation{};
};

/// Makes a building of features: levels, rooms, doors in their walls, connections, places, and
/// what is doubtful about them.
ImportedBuilding assemble(std::vector<PlanFeature> features, const std::vector<LevelFact>& facts);

}  // namespace docent::import
