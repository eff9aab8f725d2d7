#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "config/located.h"
#include "config/text_faults.h"
#include "runtime/model/exhibit/exhibit.h"
#include "runtime/model/geometry/vec2.h"

namespace docent::config {

// The fields' manual is their table in museum_fields.h, which checks the files and makes
// museum.schema.json.

/// How much time visitors may say that they have, where staff say nothing else.
inline constexpr std::array usual_minutes{15.0, 30.0, 60.0};
struct MuseumSection {
  Located<LocatedTexts> title, welcome;
  Located<LocatedList> languages;
  Located<Vec2> origin;  ///< Degrees: latitude and longitude of [0, 0].
  Located<std::string> time_zone;
  Located<LocatedList> holidays;
  Located<LocatedNumbers> minutes;  ///< That a visitor may have; usual_minutes where not given.
};
struct FloorSection {
  Place place;
  Located<std::string> name, plan, short_name;
  Located<std::int64_t> ordinal;
  Located<double> height;
  Located<LocatedTexts> title;
};
/// Where a connection meets a floor.
struct StopSection {
  Place place;
  Located<std::string> floor;
  Located<Vec2> position;
  Located<double> facing;  ///< Degrees counter-clockwise from east, as written.
};
/// By ConnectionKind and by ConnectionDirection.
inline constexpr std::array<std::string_view, 4> connection_kinds{"stairs", "escalator", "lift",
                                                                  "ramp"};
inline constexpr std::array<std::string_view, 3> connection_directions{"both", "up", "down"};
struct ConnectionSection {
  Place place;
  Located<std::string> id, kind, direction;
  Located<std::vector<StopSection>> stops;
  Located<bool> step_free, closed;
  Located<std::string> hours;
  Located<double> wait_seconds, seconds_per_floor;
  Located<double> slope;  ///< Of a ramp: metres up for a metre along.
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
  Located<std::string> model;               ///< A file: the museum's own character.
};
/// The museum's own look.
struct LookSection {
  Located<std::string> logo, logo_at_night;        ///< Files.
  Located<std::string> paper, ink, accent, focus;  ///< Colours, as they are written.
  Located<LocatedList> title_font, text_font;      ///< Files.
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
  Located<bool> closed;
  Located<std::string> hours;
};
inline constexpr std::array<std::string_view, 3> door_openings{"push", "pull", "sliding"};
inline constexpr std::array<std::string_view, 5> door_swings{"none", "left", "right", "double",
                                                             "sliding"};
struct DoorSection {
  Place place;
  Located<std::string> id, name, floor, opens, swing;
  Located<Vec2> a, b;
  Located<bool> closed;
  Located<std::string> hours;

  /// What it goes by: its id, else its name.
  const Located<std::string>& called() const noexcept { return id.given ? id : name; }
};
struct PlaceSection {
  Place place;  ///< In the file.
  Located<std::string> id, kind, floor;
  Located<Vec2> position;
  Located<LocatedTexts> title;
};
/// What visitors may choose of a way.
struct WaySection {
  Place place;
  Located<std::string> kind;
  Located<LocatedTexts> title;
};
/// A case, a plinth or a table: what takes a part of the floor, and exhibits stand in or on.
struct CaseSection {
  Place place;
  Located<std::string> id, floor;
  Located<Vec2> position;  ///< Its middle.
  Located<double> facing;  ///< Degrees counter-clockwise from east, as written.
  Located<Size> size;
};
/// A further picture of an exhibit.
struct PictureSection {
  Place place;
  Located<std::string> image;
  Located<LocatedTexts> caption, description;
  Located<LocatedTexts> captions;  ///< Files: what is read while a video plays.
};
/// What one may listen to at an exhibit.
struct ExhibitSoundSection {
  Place place;
  Located<std::string> recording;  ///< A file for everybody; or else ...
  Located<LocatedTexts> spoken;    ///< ... files by language.
  Located<LocatedTexts> title, description;
  Located<LocatedTexts> captions;  ///< Files: what is read while it plays.
};
struct ExhibitSection {
  Place place;
  /// `in` names the case that it stands in; the loader has then made its other fields those of the
  /// floor (museum_cases.h).
  Located<std::string> id, floor, in;
  Located<Vec2> position;
  Located<double> facing;  ///< Degrees counter-clockwise from east, as written.
  Located<Size> size;      ///< Of the floor that it takes where it stands free.
  Located<Vec2> view;
  Located<std::string> image;
  Located<std::vector<PictureSection>> pictures;
  Located<std::vector<ExhibitSoundSection>> sounds;
  /// `more` has what the files of `more_file` hold, too, once the museum is loaded.
  Located<LocatedTexts> title, text, description, more, more_file, artist, subject, period;
  Located<bool> closed;
  Located<std::string> hours;
  Located<double> weight, looking_seconds;
  Located<std::string> model;    ///< A file: its own shape.
  Located<Outline> turned;       ///< Its own shape, where it is round ...
  Located<std::string> colour;   ///< ... as it is written ...
  Located<std::string> wrapped;  ///< ... and a file that lies round it.
  Located<std::string> relief;   ///< A file that its own shape is cut out of.
  Located<double> height;        ///< Of the object, metres.
  Located<std::string> up;       ///< The axis of the file that is up: "y" or "z".
  Located<bool> touch;           ///< It may be touched, and the guide does.
};
struct TourSection {
  Place place;
  Located<std::string> id;
  Located<LocatedTexts> title;
  Located<LocatedList> exhibits;
  Located<bool> fixed;
  Located<double> minutes;
};

/// How a piece of what the kiosk says is to sound.
struct SpeechSection {
  Place place;
  Located<std::string> language, text;
  Located<std::string> recording;  ///< A file.
  Located<std::string> reading;    ///< What the voice reads instead.
};

/// Where exhibits come from besides the files of exhibits/: a spreadsheet (CSV), of which a line is
/// an object, or IIIF manifests. The fields of an exhibit name columns; IIIF needs none.
struct SourceSection {
  Place place;
  Located<std::string> file, encoding, separator;
  Located<std::string> id, image, floor, facing;
  Located<LocatedTexts> title, text, artist, subject, period;
  Located<LocatedList> position;  ///< The columns of east and north.
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
  LookSection look;
  AmbientSection ambient;
  MotionSection motion;
  std::vector<RoomSection> rooms;
  std::vector<DoorSection> doors;
  std::vector<ConnectionSection> connections;
  std::vector<PlaceSection> places;
  std::vector<WaySection> ways;
  std::vector<SourceSection> sources;
  std::vector<CaseSection> cases;
  std::vector<ExhibitSection> exhibits;  ///< In the order of the files' names.
  std::vector<TourSection> tours;
  std::vector<SpeechSection> speech;
  std::vector<std::string> languages;  ///< As given, else those of the texts. Never empty.
  std::vector<WordsFile> words;        ///< In the order of `languages`, where the file exists.
};

/// Reads a museum folder. All mistakes of all files are found in one run.
Loaded<MuseumConfig> load_museum_config(const std::filesystem::path& folder);

/// Reads the words of one language. Their places are in file 0.
Loaded<WordsFile> load_words(const std::filesystem::path& file, const std::string& tag);

/// What tours name that is no exhibit, each with its place. With a [source] that is known only once
/// its objects are read; without one the loader has asked already.
std::vector<Diagnostic> unknown_exhibits(const MuseumConfig& config);

/// Which fonts the museum's texts are set in.
inline Fonts fonts_of(const MuseumConfig& config) noexcept {
  return config.look.text_font.value.empty() && config.look.title_font.value.empty() ? Fonts::Kiosk
                                                                                     : Fonts::Own;
}

/// The floor that a name stands for: an index into config.floors. An empty name is the first.
std::size_t floor_index(const MuseumConfig& config, const std::string& name);

/// A diagnostic about a place in one of the config's files.
Diagnostic diagnostic_at(const MuseumConfig& config, const Place& place, std::string code,
                         std::string message, std::string label = {}, std::string hint = {});

/// What an exhibit lacks that it must have. With a [source] that is known only once its objects are
/// read; without one the loader has asked already.
std::vector<Diagnostic> missing_fields(const MuseumConfig& config, const ExhibitSection& exhibit);

/// The JSON Schema of the museum's files, made from the same table that checks them.
std::string museum_schema();

}  // namespace docent::config
