#pragma once

#include <array>
#include <limits>
#include <string_view>

#include "config/exhibit_fields.h"
#include "config/fields.h"
#include "config/museum_config.h"
#include "runtime/model/museum.h"
#include "runtime/model/place_kind.h"
#include "runtime/model/way_offer.h"

/// The fields of a museum's files: their one definition. Internal to config.
namespace docent::config {

inline constexpr std::array museum_fields{
    Field<MuseumSection>{"title", &MuseumSection::title, Presence::Optional,
                         "The museum's name, by language: title.en = \"...\""},
    Field<MuseumSection>{"welcome", &MuseumSection::welcome, Presence::Optional,
                         "What the welcome screen says, by language"},
    Field<MuseumSection>{
        "languages", &MuseumSection::languages, Presence::Optional,
        "Language tags such as \"en\"; the first is the one the kiosk starts with"},
    Field<MuseumSection>{"origin", &MuseumSection::origin, Presence::Optional,
                         "Latitude and longitude of [0, 0], where plans in degrees begin; written "
                         "by import, and the same for all floors"},
    Field<MuseumSection>{"time_zone", &MuseumSection::time_zone, Presence::Optional,
                         "Whose time all hours are in, such as \"Europe/Berlin\"; the kiosk's own "
                         "where it is not said"},
    Field<MuseumSection>{"holidays", &MuseumSection::holidays, Presence::Optional,
                         "The public holidays, PH in hours: \"Dec 25\" of every year, "
                         "\"2027 Mar 26\" of one"},
    Field<MuseumSection>{"minutes",
                         &MuseumSection::minutes,
                         Presence::Optional,
                         "How much time visitors may say that they have; for each the best round "
                         "is made, by the exhibits' weights; [15, 30, 60] where it is not said, "
                         "[] for none",
                         {5, 480}},
};

inline constexpr std::array floor_fields{
    Field<FloorSection>{"name",
                        &FloorSection::name,
                        Presence::Required,
                        "What other sections call this floor",
                        {},
                        Form::Name},
    Field<FloorSection>{"plan",
                        &FloorSection::plan,
                        Presence::Required,
                        "A GeoJSON file: where one can walk",
                        {},
                        Form::File},
    Field<FloorSection>{"ordinal",
                        &FloorSection::ordinal,
                        Presence::Optional,
                        "Which storey it is: 0 on the ground, -1 below it; where it is not said, "
                        "how many floors are written before it",
                        {-100, 1000}},
    Field<FloorSection>{"height",
                        &FloorSection::height,
                        Presence::Optional,
                        "Metres above the ground; 4 for each ordinal where it is not said",
                        {-1000, 1000}},
    Field<FloorSection>{"title", &FloorSection::title, Presence::Optional,
                        "What visitors call it, by language"},
    Field<FloorSection>{"short", &FloorSection::short_name, Presence::Optional,
                        "What a lift's button says, such as \"G\"; the ordinal where it is not "
                        "said"},
};

inline constexpr std::array stop_fields{
    Field<StopSection>{"floor",
                       &StopSection::floor,
                       Presence::Required,
                       "The floor that it leads to",
                       {},
                       Form::Name},
    Field<StopSection>{"position", &StopSection::position, Presence::Required,
                       "Where one stands before going in: [east, north] in metres"},
    Field<StopSection>{"facing",
                       &StopSection::facing,
                       Presence::Optional,
                       "Where one looks who goes in, degrees counter-clockwise from east",
                       {-360, 360}},
};

inline constexpr std::array connection_fields{
    Field<ConnectionSection>{"id",
                             &ConnectionSection::id,
                             Presence::Required,
                             "A short name that stays: letters, digits and hyphens",
                             {},
                             Form::Identifier},
    Field<ConnectionSection>{"kind",
                             &ConnectionSection::kind,
                             Presence::Required,
                             "What it is",
                             {},
                             Form::OneOf,
                             connection_kinds},
    Field<ConnectionSection>{"stops", &ConnectionSection::stops, Presence::Required,
                             "Where it meets floors: two or more, each on another floor"},
    Field<ConnectionSection>{"direction",
                             &ConnectionSection::direction,
                             Presence::Optional,
                             "Which way one may go; both where it is not said",
                             {},
                             Form::OneOf,
                             connection_directions},
    Field<ConnectionSection>{"step_free", &ConnectionSection::step_free, Presence::Optional,
                             "Can wheels take it? Lifts and ramps can where it is not said"},
    Field<ConnectionSection>{"closed", &ConnectionSection::closed, Presence::Optional,
                             "true while nobody may take it"},
    Field<ConnectionSection>{"hours", &ConnectionSection::hours, Presence::Optional, hours_manual},
    Field<ConnectionSection>{"wait_seconds",
                             &ConnectionSection::wait_seconds,
                             Presence::Optional,
                             "How long one waits for it on the average; 25 for a lift where it is "
                             "not said, doors included",
                             {0, 3600}},
    Field<ConnectionSection>{"seconds_per_floor",
                             &ConnectionSection::seconds_per_floor,
                             Presence::Optional,
                             "How long it takes from floor to floor; 3 for a lift where it is not "
                             "said, for the others as long as their floors' heights take",
                             {0, 3600}},
    Field<ConnectionSection>{"slope",
                             &ConnectionSection::slope,
                             Presence::Optional,
                             "Of a ramp: metres up for each metre along; 0.06 where it is not said",
                             {0.005, 0.5}},
};

inline constexpr std::array place_fields{
    Field<PlaceSection>{"id",
                        &PlaceSection::id,
                        Presence::Required,
                        "A short name that stays: letters, digits and hyphens",
                        {},
                        Form::Identifier},
    Field<PlaceSection>{"kind",
                        &PlaceSection::kind,
                        Presence::Required,
                        "What it is",
                        {},
                        Form::OneOf,
                        place_kind_names},
    Field<PlaceSection>{"floor", &PlaceSection::floor, Presence::Optional,
                        "The floor it is on; the first where it is not said"},
    Field<PlaceSection>{"position", &PlaceSection::position, Presence::Required,
                        "[east, north] in metres: where one stands to use it, or a wall or a door "
                        "behind which it is"},
    Field<PlaceSection>{"title", &PlaceSection::title, Presence::Optional,
                        "What it is called, by language; its kind's name where it is not said"},
};

inline constexpr std::array kiosk_fields{
    Field<KioskSection>{
        "id",
        &KioskSection::id,
        Presence::Optional,
        "What kiosk.toml calls it (kiosk = \"...\"); each of several [[kiosk]] has one",
        {},
        Form::Identifier},
    Field<KioskSection>{"floor", &KioskSection::floor, Presence::Optional,
                        "The floor it stands on; the first where it is not said"},
    Field<KioskSection>{"position", &KioskSection::position, Presence::Required,
                        "You are here: [east, north] in metres"},
    Field<KioskSection>{"facing",
                        &KioskSection::facing,
                        Presence::Optional,
                        "Where a visitor at the kiosk looks, degrees counter-clockwise from east",
                        {-360, 360}},
};

inline constexpr std::array avatar_fields{
    Field<AvatarSection>{"radius",
                         &AvatarSection::radius,
                         Presence::Optional,
                         "Metres that the guide keeps from every wall; 0.25 where it is not said",
                         {0.05, 2}},
    Field<AvatarSection>{"model",
                         &AvatarSection::model,
                         Presence::Optional,
                         "A character of the museum's own that guides instead of ours: a VRM, GLB "
                         "or glTF file of a person with a skeleton",
                         {},
                         Form::File},
};

inline constexpr std::array look_fields{
    Field<LookSection>{
        "logo",
        &LookSection::logo,
        Presence::Optional,
        "The museum's sign, above its name on the welcome screen: a picture, best an "
        "SVG or a PNG without a ground",
        {},
        Form::File},
    Field<LookSection>{"logo_at_night",
                       &LookSection::logo_at_night,
                       Presence::Optional,
                       "The same for dark paper",
                       {},
                       Form::File},
    Field<LookSection>{"accent",
                       &LookSection::accent,
                       Presence::Optional,
                       "The colour of what invites to touch, 4:1 against the paper or more; "
                       "\"#D2452D\" where it is not said",
                       {},
                       Form::Colour},
    Field<LookSection>{"focus",
                       &LookSection::focus,
                       Presence::Optional,
                       "The colour of the keypad's frame, 3:1 against the paper or more; "
                       "\"#1D7874\" where it is not said",
                       {},
                       Form::Colour},
    Field<LookSection>{"paper",
                       &LookSection::paper,
                       Presence::Optional,
                       "The colour of panels and of all round the model: a light one; \"#F5F1E8\" "
                       "where it is not said",
                       {},
                       Form::Colour},
    Field<LookSection>{"ink",
                       &LookSection::ink,
                       Presence::Optional,
                       "The colour of letters, 7:1 against the paper or more; \"#1E1C1A\" where it "
                       "is not said",
                       {},
                       Form::Colour},
    Field<LookSection>{"title_font", &LookSection::title_font, Presence::Optional,
                       "Font files (TTF, OTF) of one family, for titles: regular and, if there is "
                       "one, semibold"},
    Field<LookSection>{"text_font", &LookSection::text_font, Presence::Optional,
                       "Font files (TTF, OTF) of one family, for all else: regular, medium, "
                       "semibold"},
};

inline constexpr std::array ambient_fields{
    Field<AmbientSection>{"count",
                          &AmbientSection::count,
                          Presence::Optional,
                          "Strolling visitors on the screen; none where it is not said",
                          {0, std::numeric_limits<double>::infinity()}},
    Field<AmbientSection>{"from", &AmbientSection::from, Presence::Optional,
                          "Where they come from: [east, north] in metres on the kiosk's floor, or "
                          "several such places; without it they are there already, spread over "
                          "the exhibits"},
    Field<AmbientSection>{"look",
                          &AmbientSection::look,
                          Presence::Optional,
                          "Seconds that one looks at an exhibit, [least, most]; [6, 20] where it "
                          "is not said",
                          {1, Ambient::longest_look}},
};

inline constexpr std::array motion_fields{
    Field<MotionSection>{"clips",
                         &MotionSection::clips,
                         Presence::Optional,
                         "A folder of BVH or ASF/AMC recordings to walk with",
                         {},
                         Form::File},
};

inline constexpr std::array<std::string_view, 2> pavings{"oak", "stone"};

inline constexpr std::array room_fields{
    Field<RoomSection>{"id",
                       &RoomSection::id,
                       Presence::Required,
                       "A short name that stays: letters, digits and hyphens",
                       {},
                       Form::Identifier},
    Field<RoomSection>{"floor", &RoomSection::floor, Presence::Optional,
                       "The floor it is on; the first where it is not said"},
    Field<RoomSection>{"title", &RoomSection::title, Presence::Required,
                       "The gallery's name, by language"},
    Field<RoomSection>{"label", &RoomSection::label, Presence::Required,
                       "Where its name stands on the plan: [east, north] in metres"},
    Field<RoomSection>{"outline", &RoomSection::outline, Presence::Optional,
                       "Its corners: [[east, north], ...] in metres; exhibits inside belong to it"},
    Field<RoomSection>{"paving",
                       &RoomSection::paving,
                       Presence::Optional,
                       "oak or stone; oak where it is not said",
                       {},
                       Form::OneOf,
                       pavings},
    Field<RoomSection>{"closed", &RoomSection::closed, Presence::Optional,
                       "true while nobody may enter: all doors of its outline are closed"},
    Field<RoomSection>{"hours", &RoomSection::hours, Presence::Optional, hours_manual},
};

inline constexpr std::array door_fields{
    Field<DoorSection>{"id",
                       &DoorSection::id,
                       Presence::Optional,
                       "A short name that stays: letters, digits and hyphens; its name where it is "
                       "not said",
                       {},
                       Form::Identifier},
    Field<DoorSection>{
        "name", &DoorSection::name, Presence::Optional, "What staff call it", {}, Form::Name},
    Field<DoorSection>{"floor", &DoorSection::floor, Presence::Optional,
                       "The floor it is on; the first where it is not said"},
    Field<DoorSection>{"a", &DoorSection::a, Presence::Required,
                       "One side of the doorway: [east, north] in metres; in a wall between two "
                       "rooms, a door opens the wall"},
    Field<DoorSection>{"b", &DoorSection::b, Presence::Required,
                       "The other side of the doorway: [east, north] in metres"},
    Field<DoorSection>{
        "opens",
        &DoorSection::opens,
        Presence::Optional,
        "How it opens for who comes from where a is on the left: push (a leaf that "
        "swings both ways, pushed by hand from either side), pull (its leaf comes "
        "towards them, drawn by a hand; from the other side it is pushed) or sliding "
        "(slid by a hand); it stands open where neither this nor 'swing' is said",
        {},
        Form::OneOf,
        door_openings},
    Field<DoorSection>{"swing",
                       &DoorSection::swing,
                       Presence::Optional,
                       "Where its leaf hangs, seen from where a is on the left: left (at a), right "
                       "(at b), double (two leaves), none (no leaf) or sliding; double where it is "
                       "not said and the door is wider than 1.3 m, else left",
                       {},
                       Form::OneOf,
                       door_swings},
    Field<DoorSection>{"closed", &DoorSection::closed, Presence::Optional,
                       "true while nobody may pass"},
    Field<DoorSection>{"hours", &DoorSection::hours, Presence::Optional, hours_manual},
};

inline constexpr std::array case_fields{
    Field<CaseSection>{"id",
                       &CaseSection::id,
                       Presence::Required,
                       "A short name that stays: letters, digits and hyphens",
                       {},
                       Form::Identifier},
    Field<CaseSection>{"floor", &CaseSection::floor, Presence::Optional,
                       "The floor it stands on; the first where it is not said"},
    Field<CaseSection>{"position", &CaseSection::position, Presence::Required,
                       "Its middle: [east, north] in metres"},
    Field<CaseSection>{"facing",
                       &CaseSection::facing,
                       Presence::Optional,
                       "Where its front looks, degrees counter-clockwise from east; 270 where it "
                       "is not said",
                       {-360, 360}},
    Field<CaseSection>{"size", &CaseSection::size, Presence::Required,
                       "Metres: the side of a square, or [across its front, deep]", size_limits},
};

inline constexpr std::array way_fields{
    Field<WaySection>{"kind",
                      &WaySection::kind,
                      Presence::Required,
                      "What of it: that it is the shortest, leads through the middle of the rooms "
                      "(skeleton) or along the walls (offset), is step-free, or has no escalators",
                      {},
                      Form::OneOf,
                      way_choice_names},
    Field<WaySection>{"title", &WaySection::title, Presence::Optional,
                      "What the museum calls it, by language; the kiosk's own word where it is "
                      "not said"},
};

inline constexpr std::array tour_fields{
    Field<TourSection>{"id",
                       &TourSection::id,
                       Presence::Required,
                       "A short name that stays: letters, digits and hyphens",
                       {},
                       Form::Identifier},
    Field<TourSection>{"title", &TourSection::title, Presence::Required,
                       "What visitors call it, by language"},
    Field<TourSection>{"exhibits", &TourSection::exhibits, Presence::Optional,
                       "The exhibits' ids; where they are not said, the best that there is time "
                       "for in its minutes, by their weights"},
    Field<TourSection>{"fixed", &TourSection::fixed, Presence::Optional,
                       "true: in the order written; else in the order of the shortest walk"},
    Field<TourSection>{"minutes",
                       &TourSection::minutes,
                       Presence::Optional,
                       "How long it may take from the kiosk to the last look, ways and looking "
                       "together",
                       {1, 600}},
};

inline constexpr std::array<std::string_view, 4> separators{",", ";", "|", "tab"};

inline constexpr std::array speech_fields{
    Field<SpeechSection>{"language",
                         &SpeechSection::language,
                         Presence::Required,
                         "The tag of one of the museum's languages",
                         {},
                         Form::Identifier},
    Field<SpeechSection>{"text",
                         &SpeechSection::text,
                         Presence::Required,
                         "What is said: a title, a text or a word of the interface, whole",
                         {},
                         Form::Name},
    Field<SpeechSection>{"recording",
                         &SpeechSection::recording,
                         Presence::Optional,
                         "A recording of it, WAV or Opus; it wins over every voice",
                         {},
                         Form::File},
    Field<SpeechSection>{"reading", &SpeechSection::reading, Presence::Optional,
                         "What the voice reads instead, such as kana for kanji"},
};

inline constexpr std::array source_fields{
    Field<SourceSection>{"file",
                         &SourceSection::file,
                         Presence::Required,
                         "A CSV file, a IIIF manifest or collection (JSON), or a folder of them",
                         {},
                         Form::File},
    Field<SourceSection>{"encoding", &SourceSection::encoding, Presence::Optional,
                         "Of a CSV file: \"utf-8\", \"windows-1252\", \"utf-16\"; found out where "
                         "it is not said"},
    Field<SourceSection>{"separator",
                         &SourceSection::separator,
                         Presence::Optional,
                         "What stands between the cells; found out where it is not said",
                         {},
                         Form::OneOf,
                         separators},
    Field<SourceSection>{"id", &SourceSection::id, Presence::Optional,
                         "The column of the object's number; exhibits get it as their id, with a "
                         "hyphen for what an id may not hold"},
    Field<SourceSection>{"title", &SourceSection::title, Presence::Optional,
                         "Columns by language: title.en = \"Title\""},
    Field<SourceSection>{"text", &SourceSection::text, Presence::Optional,
                         "Columns by language: text.en = \"Description\""},
    Field<SourceSection>{"artist", &SourceSection::artist, Presence::Optional,
                         "Columns of who made it, by language: artist.en = \"Maker\""},
    Field<SourceSection>{
        "subject", &SourceSection::subject, Presence::Optional,
        "Columns of what it is about, by language, in the same words for all that belong together: "
        "subject.en = \"Theme\"; of several in a cell, with ; or | between them, the first"},
    Field<SourceSection>{"period", &SourceSection::period, Presence::Optional,
                         "Columns of when it was made, by language, likewise: period.en = "
                         "\"Dynasty\""},
    Field<SourceSection>{
        "image", &SourceSection::image, Presence::Optional,
        "The column of the picture's file; it is looked for beside the CSV file, in "
        "the museum's folder and in images/"},
    Field<SourceSection>{"position", &SourceSection::position, Presence::Optional,
                         "The two columns of its place: [\"east\", \"north\"]; objects without one "
                         "are shown where a [[exhibit]] of that id gives it"},
    Field<SourceSection>{"facing", &SourceSection::facing, Presence::Optional,
                         "The column of where it looks, in degrees"},
    Field<SourceSection>{"floor", &SourceSection::floor, Presence::Optional,
                         "The column of the floor's name"},
};

inline constexpr std::array<std::string_view, 2> directions{"left-to-right", "right-to-left"};

inline constexpr std::array words_fields{
    Field<WordsFile>{"name",
                     &WordsFile::name,
                     Presence::Required,
                     "The language's name in itself",
                     {},
                     Form::Name},
    Field<WordsFile>{"direction",
                     &WordsFile::direction,
                     Presence::Required,
                     "left-to-right or right-to-left",
                     {},
                     Form::OneOf,
                     directions},
    Field<WordsFile>{"words",
                     &WordsFile::words,
                     Presence::Required,
                     "The interface's words by key",
                     {},
                     Form::Keys},
};

/// The sections of museum.toml: `visit.one` for [name], `visit.many` for [[name]].
void museum_sections(auto& visit, auto& config) {
  visit.one("museum", "The museum as a whole", museum_fields, config.museum);
  visit.many("floor", "A floor of the building", floor_fields, config.floors);
  visit.one_or_many("kiosk", "Where the kiosk stands; [[kiosk]] for each of several", kiosk_fields,
                    config.kiosks);
  visit.one("avatar", "The guide", avatar_fields, config.avatar);
  visit.one("look", "The museum's own look: logo, colours, letters", look_fields, config.look);
  visit.one("ambient", "Other visitors on the screen", ambient_fields, config.ambient);
  visit.one("motion", "How the guide moves", motion_fields, config.motion);
  visit.many("room", "A gallery: a name for a part of a floor", room_fields, config.rooms);
  visit.one_or_many("source", "Where exhibits come from besides exhibits/: CSV or IIIF",
                    source_fields, config.sources);
  visit.many("connection", "Stairs, an escalator, a lift or a ramp from floor to floor",
             connection_fields, config.connections);
  visit.many("place", "Toilets, an exit, a seat: what visitors ask for besides exhibits",
             place_fields, config.places);
  visit.many("way",
             "A way that visitors may choose, in the order of the buttons; guides walk the first "
             "that is a shortest, skeleton or offset one until another is chosen; where there is "
             "none of these sections visitors may choose them all",
             way_fields, config.ways);
  visit.many("door", "A doorway that staff can close", door_fields, config.doors);
  visit.many("case", "A case, plinth or table that the plan does not show", case_fields,
             config.cases);
  visit.many("tour", "A round of exhibits, one after another", tour_fields, config.tours);
  visit.many("speech", "How something is said: staff's recording, or how a voice should read it",
             speech_fields, config.speech);
}

/// The sections of a file of exhibits/.
void exhibit_sections(auto& visit, auto& config) {
  visit.many("exhibit", "Something to look at", exhibit_fields, config.exhibits);
}

}  // namespace docent::config
