#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "content/import/building/imported_building.h"
#include "content/import/building/lay_out.h"

namespace docent::import {

/// A building with its levels laid out: what is written and told.
struct LaidBuilding {
  ImportedBuilding building;
  std::vector<LaidLevel> levels;  ///< By ImportedBuilding::levels.
};

/// Lays out all levels; doubts are added to the building's. Stops of connections and places move
/// to where one can stand; those that cannot are told and left out of what is written.
LaidBuilding lay_out(ImportedBuilding building);

/// A text file of a museum's folder.
struct MuseumText {
  std::string name;  ///< `museum.toml`, `floors/level-0.geojson`.
  std::string text;
};

/// What a museum's files say besides the building.
struct MuseumManner {
  std::string title;  ///< What it is called where the plan does not say.
  /// Has the kiosk words of this language? Titles in others are written as comments.
  std::function<bool(const std::string& language)> speaks;
};

/// The files that a museum of this building begins with. Places to which no way leads from where
/// the kiosk is put are added to the building's doubts, and left out.
std::vector<MuseumText> museum_texts(LaidBuilding& laid, const MuseumManner& manner);

/// An outer ring's area without its holes', square metres.
double area_of(const ImportedRoom& room);
/// A point in the room where one can stand, if there is one.
Vec2 point_in(const ImportedRoom& room, const LaidLevel& level);

}  // namespace docent::import
