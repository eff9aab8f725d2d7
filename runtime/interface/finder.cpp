#include "runtime/interface/finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "runtime/interface/places.h"
#include "runtime/search/fold.h"

namespace docent::interface {
namespace {

// Less is better: what something is called comes before what it belongs to.
constexpr std::uint8_t by_title = 0, by_number = 1, by_artist = 2, by_inventory = 3, by_tag = 10,
                       by_gallery = 12;
constexpr std::uint8_t other_language = 250;  ///< That staff wrote and the kiosk does not speak.

// Entries: the exhibits, the kinds of places by their numbers, the places.

std::uint32_t first_kind(const Museum& museum) noexcept {
  return static_cast<std::uint32_t>(museum.exhibits.size());
}
std::uint32_t first_place(const Museum& museum) noexcept {
  return first_kind(museum) + static_cast<std::uint32_t>(PlaceKind::Count);
}

/// Gathers all that can be found in a museum.
class Gathering {
 public:
  explicit Gathering(const Museum& museum)
      : museum_(museum),
        builder_(first_place(museum) + static_cast<std::uint32_t>(museum.places.size())) {}

  search::Index index() && {
    add_exhibits();
    add_galleries();
    add_tags(&Exhibit::subject);
    add_tags(&Exhibit::period);
    add_places();
    return std::move(builder_).build();
  }

 private:
  std::uint8_t language_of(std::string_view tag) const noexcept {
    const auto found = std::ranges::find(museum_.languages, tag, &Language::tag);
    return found == museum_.languages.end()
               ? other_language
               : static_cast<std::uint8_t>(found - museum_.languages.begin());
  }
  void add(std::uint32_t owner, std::uint8_t weight, const LocalText& text) {
    for (const auto& [tag, words] : text) add(owner, language_of(tag), weight, words);
  }
  void add(std::uint32_t owner, std::uint8_t language, std::uint8_t weight,
           const std::string& words) {
    builder_.add(owner, language, weight, words);
    if (const auto reading = museum_.readings.find(words); reading != museum_.readings.end())
      builder_.add_reading(owner, language, weight, reading->second);
  }
  void add_exhibits() {
    for (std::uint32_t i = 0; i < museum_.exhibits.size(); ++i) {
      add(i, by_title, museum_.exhibits[i].title);
      add(i, by_artist, museum_.exhibits[i].artist);
      builder_.add(i, search::no_language, by_number, fmt::format("{}", i + 1));
      builder_.add(i, search::no_language, by_inventory, museum_.exhibits[i].id);
    }
  }
  void add_galleries() {
    std::vector<std::uint32_t> inside;
    for (std::uint32_t room = 0; room < museum_.rooms.size(); ++room) {
      inside.clear();
      for (std::uint32_t i = 0; i < museum_.exhibits.size(); ++i)
        if (museum_.exhibits[i].room == room) inside.push_back(i);
      if (!inside.empty()) add(builder_.add_group(inside), by_gallery, museum_.rooms[room].title);
    }
  }
  /// What has the same tag in a language is found together, by words that are kept once.
  void add_tags(LocalText Exhibit::* tag) {
    std::map<std::pair<std::string_view, std::string_view>, std::vector<std::uint32_t>> tagged;
    for (std::uint32_t i = 0; i < museum_.exhibits.size(); ++i)
      for (const auto& [language, words] : museum_.exhibits[i].*tag)
        tagged[{language, words}].push_back(i);
    for (const auto& [key, exhibits] : tagged)
      add(builder_.add_group(exhibits), language_of(key.first), by_tag, std::string(key.second));
  }
  void add_places() {
    for (const PlaceKind kind : kinds_of_places(museum_)) {
      const std::string key = word_of(kind);
      for (const Language& language : museum_.languages)
        if (const auto word = language.words.find(key); word != language.words.end())
          add(first_kind(museum_) + static_cast<std::uint32_t>(kind), language_of(language.tag),
              by_title, word->second);
    }
    for (std::uint32_t i = 0; i < museum_.places.size(); ++i)
      add(first_place(museum_) + i, by_title, museum_.places[i].title);
  }

  const Museum& museum_;
  search::IndexBuilder builder_;
};

}  // namespace

Action meant_by(const Museum& museum, std::uint32_t entry) noexcept {
  if (entry < first_kind(museum)) return {Action::Kind::Choose, entry};
  if (entry < first_place(museum)) return {Action::Kind::Seek, entry - first_kind(museum)};
  return {Action::Kind::GoToPlace, entry - first_place(museum)};
}

void Finder::look_up(InterfaceState& state) {
  Found& found = state.found;
  found = {};
  const std::u16string query = search::folded(state.typed.letters());
  if (query.empty()) return;
  if (!index_) index_ = Gathering(museum_).index();
  const auto hits = search::find(*index_, query, static_cast<std::uint8_t>(state.language), desk_);
  found.total = static_cast<std::uint32_t>(hits.size());
  for (const search::Hit& hit : hits.first(std::min(hits.size(), Found::most)))
    found.entry[found.count++] = hit.entry;
}

}  // namespace docent::interface
