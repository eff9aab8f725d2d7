#include "content/command/museum_texts.h"

#include <algorithm>

namespace docent::command {

std::vector<MuseumText> museum_texts(const config::MuseumConfig& config) {
  std::vector<MuseumText> all;
  const auto add = [&](std::string id, std::string what, std::string exhibit,
                       const config::Place& owner,
                       const config::Located<config::LocatedTexts>& texts) {
    if (!texts.value.empty())
      all.push_back({std::move(id), std::move(what), std::move(exhibit), owner, &texts.value});
  };
  add("museum.title", "title", {}, config.museum.title.place, config.museum.title);
  add("museum.welcome", "welcome", {}, config.museum.welcome.place, config.museum.welcome);
  for (const config::FloorSection& floor : config.floors)
    add("floor." + floor.name.value + ".title", "title", {}, floor.place, floor.title);
  for (const config::RoomSection& room : config.rooms)
    add("room." + room.id.value + ".title", "title", {}, room.place, room.title);
  for (const config::ExhibitSection& exhibit : config.exhibits) {
    add(exhibit.id.value + ".title", "title", exhibit.id.value, exhibit.id.place, exhibit.title);
    add(exhibit.id.value + ".text", "text", exhibit.id.value, exhibit.id.place, exhibit.text);
    add(exhibit.id.value + ".description", "description", exhibit.id.value, exhibit.id.place,
        exhibit.description);
    if (exhibit.more_file.value.empty())  // else translators get the files
      add(exhibit.id.value + ".more", "more", exhibit.id.value, exhibit.id.place, exhibit.more);
    for (std::size_t i = 0; i < exhibit.pictures.value.size(); ++i) {
      const config::PictureSection& picture = exhibit.pictures.value[i];
      const std::string id = exhibit.id.value + ".pictures." + std::to_string(i + 2);
      add(id + ".caption", "caption", {}, picture.place, picture.caption);
      add(id + ".description", "description", {}, picture.place, picture.description);
    }
    for (std::size_t i = 0; i < exhibit.sounds.value.size(); ++i) {
      const config::ExhibitSoundSection& sound = exhibit.sounds.value[i];
      const std::string id = exhibit.id.value + ".sounds." + std::to_string(i + 1);
      add(id + ".title", "title", {}, sound.place, sound.title);
      add(id + ".description", "description", {}, sound.place, sound.description);
    }
  }
  return all;
}

const config::Located<std::string>* written_in(const MuseumText& text, std::string_view language) {
  const auto found = text.texts->find(language);
  if (found == text.texts->end()) return nullptr;
  // A text that stands in for a missing one has its place.
  const bool stands_in = std::ranges::any_of(*text.texts, [&](const auto& other) {
    return other.first != language && other.second.place.file == found->second.place.file &&
           other.second.place.range == found->second.place.range &&
           other.second.value == found->second.value;
  });
  return stands_in ? nullptr : &found->second;
}

}  // namespace docent::command
