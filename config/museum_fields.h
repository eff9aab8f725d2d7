#pragma once

#include <array>
#include <limits>

#include "config/fields.h"
#include "config/museum_config.h"
#include "runtime/model/museum.h"

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
    Field<FloorSection>{"height",
                        &FloorSection::height,
                        Presence::Optional,
                        "Metres above the ground",
                        {-1000, 1000}},
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
                       Form::Paving},
};

inline constexpr std::array door_fields{
    Field<DoorSection>{
        "name", &DoorSection::name, Presence::Required, "What staff call it", {}, Form::Name},
    Field<DoorSection>{"floor", &DoorSection::floor, Presence::Optional,
                       "The floor it is on; the first where it is not said"},
    Field<DoorSection>{"a", &DoorSection::a, Presence::Required,
                       "One side of the doorway: [east, north] in metres"},
    Field<DoorSection>{"b", &DoorSection::b, Presence::Required,
                       "The other side of the doorway: [east, north] in metres"},
    Field<DoorSection>{"closed", &DoorSection::closed, Presence::Optional,
                       "true while nobody may pass"},
};

inline constexpr std::array exhibit_fields{
    Field<ExhibitSection>{"id",
                          &ExhibitSection::id,
                          Presence::Required,
                          "A short name that stays: letters, digits and hyphens",
                          {},
                          Form::Identifier},
    Field<ExhibitSection>{"floor", &ExhibitSection::floor, Presence::Optional,
                          "The floor it is on; the first where it is not said"},
    Field<ExhibitSection>{"position", &ExhibitSection::position, Presence::Required,
                          "[east, north] in metres: on the floor, on a wall or inside a case"},
    Field<ExhibitSection>{"facing",
                          &ExhibitSection::facing,
                          Presence::Required,
                          "Where the object looks, degrees counter-clockwise from east",
                          {-360, 360}},
    Field<ExhibitSection>{"view", &ExhibitSection::view, Presence::Optional,
                          "Where a visitor stands to look at it: [east, north] in metres; found "
                          "in front of it where it is not said"},
    Field<ExhibitSection>{"image",
                          &ExhibitSection::image,
                          Presence::Optional,
                          "A picture of it: an SVG, PNG or JPEG file",
                          {},
                          Form::File},
    Field<ExhibitSection>{"title", &ExhibitSection::title, Presence::Required,
                          "What it is called, by language"},
    Field<ExhibitSection>{"text", &ExhibitSection::text, Presence::Optional,
                          "What there is to say about it, by language"},
};

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
                     Form::Direction},
    Field<WordsFile>{"words", &WordsFile::words, Presence::Required,
                     "The interface's words by key"},
};

/// The sections of museum.toml: `visit.one` for [name], `visit.many` for [[name]].
void museum_sections(auto& visit, auto& config) {
  visit.one("museum", "The museum as a whole", museum_fields, config.museum);
  visit.many("floor", "A floor of the building", floor_fields, config.floors);
  visit.one_or_many("kiosk", "Where the kiosk stands; [[kiosk]] for each of several", kiosk_fields,
                    config.kiosks);
  visit.one("avatar", "The guide", avatar_fields, config.avatar);
  visit.one("ambient", "Other visitors on the screen", ambient_fields, config.ambient);
  visit.one("motion", "How the guide moves", motion_fields, config.motion);
  visit.many("room", "A gallery: a name for a part of a floor", room_fields, config.rooms);
  visit.many("door", "A doorway that staff can close", door_fields, config.doors);
}

/// The sections of a file of exhibits/.
void exhibit_sections(auto& visit, auto& config) {
  visit.many("exhibit", "Something to look at", exhibit_fields, config.exhibits);
}

}  // namespace docent::config
