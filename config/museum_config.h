#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "config/located.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::config {

// The fields' manual is their table in museum_fields.h, which checks the files and makes
// museum.schema.json.

struct MuseumSection {
  Located<LocatedTexts> title, welcome;
  Located<std::vector<std::string>> languages;
};
struct FloorSection {
  Place place;
  Located<std::string> name, plan;
  Located<double> height;
};
struct KioskSection {
  Place place;
  Located<std::string> id;
  Located<std::string> floor;
  Located<Vec2> position;
  Located<double> facing;  ///< Degrees counter-clockwise from east, as written.
};
struct AvatarSection {
  Located<double> radius{0.25, {}, false};  ///< Metres.
};
struct AmbientSection {
  Located<std::int64_t> count;
  Located<LocatedPoints> from;
  Located<Range> look;  ///< Seconds.
};
struct MotionSection {
  Located<std::string> clips;
};
struct RoomSection {
  Place place;
  Located<std::string> id, floor;
  Located<LocatedTexts> title;
  Located<Vec2> label;
  Located<std::vector<Vec2>> outline;
  Located<std::string> paving;
};
struct DoorSection {
  Place place;
  Located<std::string> name, floor;
  Located<Vec2> a, b;
  Located<bool> closed;
};
struct ExhibitSection {
  Place place;
  Located<std::string> id, floor;
  Located<Vec2> position;
  Located<double> facing;  ///< Degrees counter-clockwise from east, as written.
  Located<Vec2> view;
  Located<std::string> image;
  Located<LocatedTexts> title, text;
};

/// The words of the interface in one language.
struct WordsFile {
  std::string tag;  ///< The file's name: BCP 47.
  Located<std::string> name, direction;
  Located<LocatedTexts> words;
};

/// A museum as its staff wrote it: museum.toml, exhibits/*.toml and words/*.toml of one folder.
/// Lengths are metres in the floor frame. References between the parts have been checked; nothing
/// has been compared with the plan yet.
struct MuseumConfig {
  std::filesystem::path folder;
  std::vector<std::string> files;  ///< By FileIndex; as diagnostics name them.
  MuseumSection museum;
  std::vector<FloorSection> floors;
  KioskSection kiosk;                ///< The first of `kiosks`, else one of which nothing is said.
  std::vector<KioskSection> kiosks;  ///< [kiosk], or several [[kiosk]], which then have ids.
  AvatarSection avatar;
  AmbientSection ambient;
  MotionSection motion;
  std::vector<RoomSection> rooms;
  std::vector<DoorSection> doors;
  std::vector<ExhibitSection> exhibits;  ///< In the order of the files' names.
  std::vector<std::string> languages;    ///< As given, else those of the texts. Never empty.
  std::vector<WordsFile> words;          ///< In the order of `languages`, where the file exists.
};

/// Reads a museum folder. All mistakes of all files are found in one run.
Loaded<MuseumConfig> load_museum_config(const std::filesystem::path& folder);

/// Reads the words of one language. Their places are in file 0.
Loaded<WordsFile> load_words(const std::filesystem::path& file, const std::string& tag);

/// The floor that a name stands for: an index into config.floors. An empty name is the first.
std::size_t floor_index(const MuseumConfig& config, const std::string& name);

/// A diagnostic about a place in one of the config's files.
Diagnostic diagnostic_at(const MuseumConfig& config, const Place& place, std::string code,
                         std::string message, std::string label = {}, std::string hint = {});

/// The JSON Schema of the museum's files, made from the same table that checks them.
std::string museum_schema();

}  // namespace docent::config
