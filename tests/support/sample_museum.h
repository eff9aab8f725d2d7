#pragma once

#include <cmath>
#include <string>

#include "config/museum_config.h"
#include "runtime/model/museum.h"
#include "tests/support/reference_data.h"

namespace docent::test {

/// The sample museum's texts, words, and its ground floor's rooms and exhibits as staff wrote them,
/// round a plain floor of the same size: enough for views, without compiling anything. Viewing
/// points are a metre in front of the exhibits.
inline Museum sample_museum_without_walls() {
  const config::Loaded<config::MuseumConfig> loaded =
      config::load_museum_config(source_dir() / "config/museum");
  const config::MuseumConfig& config = loaded.value.value();
  const auto texts = [](const config::Located<config::LocatedTexts>& located) {
    LocalText text;
    for (const auto& [tag, value] : located.value) text[tag] = value.value;
    return text;
  };

  Museum museum;
  museum.title = texts(config.museum.title);
  museum.welcome = texts(config.museum.welcome);
  for (const std::string& tag : config.languages) {
    const config::WordsFile file =
        config::load_words(source_dir() / "config/words" / (tag + ".toml"), tag).value.value();
    Language language;
    language.tag = tag;
    language.name = file.name.value;
    language.right_to_left = file.direction.value == "right-to-left";
    for (const auto& [key, value] : file.words.value) language.words[key] = value.value;
    museum.languages.push_back(std::move(language));
  }
  Floor floor;
  floor.plan.name = "ground";
  floor.plan.vertex = {{-0.8, 0}, {40, 0}, {40, 32}, {-0.8, 32}};
  floor.plan.ring = {{0, 4}};
  floor.plan.next = {1, 2, 3, 0};
  museum.floors.push_back(std::move(floor));
  const auto is_below = [](const auto& section) {
    return section.floor.value.empty() || section.floor.value == "ground";
  };
  for (const config::RoomSection& section : config.rooms)
    if (is_below(section))
      museum.rooms.push_back({.id = section.id.value,
                              .title = texts(section.title),
                              .label = section.label.value,
                              .outline = {}});
  for (const config::ExhibitSection& section : config.exhibits) {
    if (!is_below(section)) continue;
    Exhibit exhibit;
    exhibit.id = section.id.value;
    exhibit.placement = {section.position.value, glm::radians(section.facing.value)};
    const double facing = exhibit.placement.heading;
    exhibit.viewing_point = {exhibit.placement.position + Vec2{std::cos(facing), std::sin(facing)},
                             facing + glm::pi<double>()};
    exhibit.title = texts(section.title);
    exhibit.text = texts(section.text);
    exhibit.image = static_cast<std::uint32_t>(museum.images.size());
    museum.exhibits.push_back(std::move(exhibit));
    museum.images.push_back(
        {.name = section.image.value, .width = 960, .height = 960, .bytes = {}});
  }
  for (const config::PlaceSection& section : config.places)
    if (is_below(section))
      museum.places.push_back({.id = section.id.value,
                               .kind = place_kind_named(section.kind.value).value(),
                               .position = section.position.value,
                               .standing = section.position.value,
                               .title = texts(section.title)});
  for (const config::TourSection& section : config.tours) {
    Tour& tour = museum.tours.emplace_back();
    tour.id = section.id.value;
    tour.title = texts(section.title);
    for (std::uint32_t i = 0; i < 7; ++i) {
      tour.exhibits.push_back(3 * i);
      tour.arrives.push_back(100.0 * i + 40);
    }
    tour.seconds = 700;
  }
  for (const double minutes : config::usual_minutes) {
    Tour& tour = museum.tours.emplace_back();
    tour.id = "minutes-" + std::to_string(std::lround(minutes));
    tour.minutes = minutes;
    tour.exhibits = {1, 4, 7};
    tour.arrives = {60, 200, 400};
    tour.seconds = 60 * minutes - 30;
  }
  museum.kiosk = {{20, 2.6}, glm::radians(90.0)};
  return museum;
}

}  // namespace docent::test
