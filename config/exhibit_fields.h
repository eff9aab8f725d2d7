#pragma once

#include <array>
#include <string_view>

#include "config/fields.h"
#include "config/museum_config.h"

/// The fields of an exhibit, and what others share with them. Internal to config.
namespace docent::config {

/// What `hours` hold, wherever they are.
inline constexpr std::string_view hours_manual =
    "When it is open, as OpenStreetMap's opening_hours: \"Tu-Su 10:00-18:00; Dec 24,25 off\"";

/// Of what takes a part of the floor, metres.
inline constexpr FieldLimits size_limits{0, 30};

inline constexpr std::array<std::string_view, 2> up_axes{"y", "z"};

inline constexpr std::array picture_fields{
    Field<PictureSection>{"image",
                          &PictureSection::image,
                          Presence::Required,
                          "An SVG, PNG, JPEG, WebP, GIF or HEIC file, or a WebM video",
                          {},
                          Form::File},
    Field<PictureSection>{"caption", &PictureSection::caption, Presence::Optional,
                          "What visitors read below it, by language"},
    Field<PictureSection>{"description", &PictureSection::description, Presence::Optional,
                          "What it shows, by language, for those who do not see it"},
    Field<PictureSection>{"captions", &PictureSection::captions, Presence::Optional,
                          "Of a video: what is said and heard in it, as a WebVTT file, by "
                          "language; it is read while the video plays"},
};

inline constexpr std::array exhibit_sound_fields{
    Field<ExhibitSoundSection>{
        "recording",
        &ExhibitSoundSection::recording,
        Presence::Optional,
        "What is heard: a WAV, FLAC, AIFF, MP3, Opus or Vorbis file of at most 5 minutes; for "
        "what is spoken, 'spoken' by language instead",
        {},
        Form::File},
    Field<ExhibitSoundSection>{
        "spoken", &ExhibitSoundSection::spoken, Presence::Optional,
        "The same by language; visitors of a language without one hear another's"},
    Field<ExhibitSoundSection>{"title", &ExhibitSoundSection::title, Presence::Required,
                               "What one listens to, by language: it is written on its button"},
    Field<ExhibitSoundSection>{"description", &ExhibitSoundSection::description, Presence::Required,
                               "What is heard, by language, for those who do not hear it"},
    Field<ExhibitSoundSection>{
        "captions", &ExhibitSoundSection::captions, Presence::Optional,
        "What is said and heard, as a WebVTT file, by language; it is read while "
        "the sound plays"},
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
    Field<ExhibitSection>{"position", &ExhibitSection::position, Presence::UnlessSource,
                          "[east, north] in metres: on the floor, on a wall or inside a case; "
                          "with 'in', metres from the case's middle: [right, to its front]"},
    Field<ExhibitSection>{"in",
                          &ExhibitSection::in,
                          Presence::Optional,
                          "The id of the [[case]] that it stands in: it moves and turns with it",
                          {},
                          Form::Identifier},
    Field<ExhibitSection>{"facing",
                          &ExhibitSection::facing,
                          Presence::UnlessSource,
                          "Where the object looks, degrees counter-clockwise from east",
                          {-360, 360}},
    Field<ExhibitSection>{"size", &ExhibitSection::size, Presence::Optional,
                          "Of the floor that it takes where it stands free, and nobody walks: "
                          "metres, the side of a square or [across its front, deep]; 0.6 where it "
                          "is not said, 0 for what one may walk over",
                          size_limits},
    Field<ExhibitSection>{"view", &ExhibitSection::view, Presence::Optional,
                          "Where a visitor stands to look at it: [east, north] in metres; found "
                          "in front of it where it is not said"},
    Field<ExhibitSection>{"image",
                          &ExhibitSection::image,
                          Presence::Optional,
                          "A picture of it: an SVG, PNG, JPEG, WebP, GIF or HEIC file",
                          {},
                          Form::File},
    Field<ExhibitSection>{
        "pictures", &ExhibitSection::pictures, Presence::Optional,
        "Further pictures, which visitors leaf through in this order; at most 19; a video is "
        "named here, never in image"},
    Field<ExhibitSection>{"sounds", &ExhibitSection::sounds, Presence::Optional,
                          "What visitors may listen to at it, at most 4; on a glass that visitors "
                          "share it is read"},
    Field<ExhibitSection>{"title", &ExhibitSection::title, Presence::UnlessSource,
                          "What it is called, by language"},
    Field<ExhibitSection>{"text", &ExhibitSection::text, Presence::Optional,
                          "What there is to say about it, by language"},
    Field<ExhibitSection>{"description", &ExhibitSection::description, Presence::Optional,
                          "What its picture shows, by language, for those who do not see it: it is "
                          "spoken after the title, and read where there is no picture"},
    Field<ExhibitSection>{
        "more", &ExhibitSection::more, Presence::Optional,
        "A longer text, by language, for those who ask for more about it: at most 20,000 letters"},
    Field<ExhibitSection>{"more_file", &ExhibitSection::more_file, Presence::Optional,
                          "The same from a text file in UTF-8, by language"},
    Field<ExhibitSection>{"artist", &ExhibitSection::artist, Presence::Optional,
                          "Who made it, by language: visitors find it by that"},
    Field<ExhibitSection>{"subject", &ExhibitSection::subject, Presence::Optional,
                          "What it is about, by language, in the same words for all that belong "
                          "together: visitors find them by that"},
    Field<ExhibitSection>{"period", &ExhibitSection::period, Presence::Optional,
                          "When it was made, by language, in the same words for all that belong "
                          "together: visitors find them by that"},
    Field<ExhibitSection>{"closed", &ExhibitSection::closed, Presence::Optional,
                          "true while it cannot be seen"},
    Field<ExhibitSection>{"hours", &ExhibitSection::hours, Presence::Optional, hours_manual},
    Field<ExhibitSection>{"weight",
                          &ExhibitSection::weight,
                          Presence::Optional,
                          "How much it is worth seeing beside the others, where there is no time "
                          "for all: 0 never, 2 twice as much; 1 where it is not said",
                          {0, 1000}},
    Field<ExhibitSection>{"looking_seconds",
                          &ExhibitSection::looking_seconds,
                          Presence::Optional,
                          "How long a visitor looks at it; 60 where it is not said",
                          {0, 3600}},
    Field<ExhibitSection>{"model",
                          &ExhibitSection::model,
                          Presence::Optional,
                          "The object itself, as a scan or a model: a GLB, glTF, OBJ, PLY or STL "
                          "file; it stands in its case or on a plinth instead of its picture",
                          {},
                          Form::File},
    Field<ExhibitSection>{"turned",
                          &ExhibitSection::turned,
                          Presence::Optional,
                          "The object itself, if it is round like a jar: its outline from the foot "
                          "up, [[radius, height], ...] in metres, which is turned about its axis; "
                          "over the rim and down the inside where it is hollow; points are joined "
                          "round, but where they make a sharp corner",
                          {0, 30}},
    Field<ExhibitSection>{"colour",
                          &ExhibitSection::colour,
                          Presence::Optional,
                          "Of what is `turned`, where no picture lies on it; \"#B5835A\", of clay, "
                          "where it is not said",
                          {},
                          Form::Colour},
    Field<ExhibitSection>{"wrapped",
                          &ExhibitSection::wrapped,
                          Presence::Optional,
                          "A picture that lies round the outside of what is `turned`, from foot to "
                          "rim, its middle in front",
                          {},
                          Form::File},
    Field<ExhibitSection>{
        "relief",
        &ExhibitSection::relief,
        Presence::Optional,
        "The object itself, cut out of a photograph on a clear or plain ground: it "
        "stands upright, as high as `height` says",
        {},
        Form::File},
    Field<ExhibitSection>{"height",
                          &ExhibitSection::height,
                          Presence::Optional,
                          "How high the object of `model`, `turned` or `relief` is, metres; as its "
                          "file or outline has it where it is not said",
                          {0.002, 30}},
    Field<ExhibitSection>{"up",
                          &ExhibitSection::up,
                          Presence::Optional,
                          "Which axis of the file of `model` is up; as its kind usually has it "
                          "where it is not said",
                          {},
                          Form::OneOf,
                          up_axes},
    Field<ExhibitSection>{
        "touch", &ExhibitSection::touch, Presence::Optional,
        "true where visitors may touch it, a replica for example: the guide points at it, walks "
        "up and lays a hand on it where it gets to it, 0.6 to 1.7 m above the floor, near the edge "
        "of what it stands on and not under glass; where it is drawn larger than life, as on a "
        "small shared glass, it only points"},
};

}  // namespace docent::config
