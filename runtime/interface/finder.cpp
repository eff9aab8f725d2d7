#include "runtime/interface/finder.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "runtime/interface/places.h"
#include "runtime/search/fold.h"

namespace docent::interface {
namespace {

// Less is better: what something is called comes before what it belongs to.
constexpr std::uint8_t by_title = 0, by_number = 1, by_artist = 2, by_inventory = 3, by_tag = 10,
                       by_gallery = 12;
constexpr std::uint8_t other_language = 250;  ///< That staff wrote and the kiosk does not speak.

// Entries: the exhibits, the kinds of places by their numbers, the places, the galleries; the
// subjects and the periods, by the first exhibit that has them.

std::uint32_t first_kind(const Museum& museum) noexcept {
  return static_cast<std::uint32_t>(museum.exhibits.size());
}
std::uint32_t first_place(const Museum& museum) noexcept {
  return first_kind(museum) + static_cast<std::uint32_t>(PlaceKind::Count);
}

std::uint32_t first_room(const Museum& museum) noexcept {
  return first_place(museum) + static_cast<std::uint32_t>(museum.places.size());
}
std::uint32_t first_subject(const Museum& museum) noexcept {
  return first_room(museum) + static_cast<std::uint32_t>(museum.rooms.size());
}
std::uint32_t first_period(const Museum& museum) noexcept {
  return first_subject(museum) + static_cast<std::uint32_t>(museum.exhibits.size());
}

/// Takes entries one after another, as many as there is room for.
void take(Found& found, std::uint32_t entry) noexcept {
  ++found.total;
  if (found.count < Found::most) found.entry[found.count++] = entry;
}

/// The galleries that have exhibits, and what has a subject or a period of its own.
void take_groups(const Museum& museum, Found& found) {
  for (std::uint32_t room = 0; room < museum.rooms.size(); ++room)
    if (!museum.rooms[room].title.empty() &&
        std::ranges::find(museum.exhibits, room, &Exhibit::room) != museum.exhibits.end())
      take(found, first_room(museum) + room);
  const auto take_tags = [&](LocalText Exhibit::* tag, std::uint32_t first) {
    std::set<LocalText> seen;
    for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i)
      if (const LocalText& text = museum.exhibits[i].*tag;
          !text.empty() && seen.insert(text).second)
        take(found, first + i);
  };
  take_tags(&Exhibit::subject, first_subject(museum));
  take_tags(&Exhibit::period, first_period(museum));
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
  if (entry < first_room(museum)) return {Action::Kind::GoToPlace, entry - first_place(museum)};
  return {Action::Kind::Browse, entry};
}

Group group_of(const Museum& museum, std::uint32_t entry) {
  Group group{.name = {}, .kind = {}, .title = nullptr, .exhibits = {}};
  const auto gather = [&](const auto& belongs) {
    for (std::uint32_t i = 0; i < museum.exhibits.size(); ++i)
      if (belongs(museum.exhibits[i])) group.exhibits.push_back(i);
  };
  if (entry < first_subject(museum)) {
    const std::uint32_t room = entry - first_room(museum);
    group.name = "gallery:" + museum.rooms[room].id;
    group.kind = "browse_gallery";
    group.title = &museum.rooms[room].title;
    gather([&](const Exhibit& exhibit) { return exhibit.room == room; });
    return group;
  }
  const bool is_period = entry >= first_period(museum);
  LocalText Exhibit::* const tag = is_period ? &Exhibit::period : &Exhibit::subject;
  const Exhibit& first =
      museum.exhibits[entry - (is_period ? first_period(museum) : first_subject(museum))];
  group.name = (is_period ? "period:" : "subject:") + first.id;
  group.kind = is_period ? "browse_period" : "browse_subject";
  group.title = &(first.*tag);
  gather([&](const Exhibit& exhibit) { return exhibit.*tag == first.*tag; });
  return group;
}

void Finder::look_up(InterfaceState& state) {
  Found& found = state.found;
  found = {};
  const std::u16string query = search::folded(state.typed.letters());
  if (query.empty() && state.browses) {
    for (const std::uint32_t exhibit : group_of(museum_, *state.browses).exhibits)
      take(found, exhibit);
    return;
  }
  if (query.empty()) return take_groups(museum_, found);
  if (!index_) index_ = Gathering(museum_).index();
  const auto hits = search::find(*index_, query, static_cast<std::uint8_t>(state.language), desk_);
  found.total = static_cast<std::uint32_t>(hits.size());
  for (const search::Hit& hit : hits.first(std::min(hits.size(), Found::most)))
    found.entry[found.count++] = hit.entry;
}

}  // namespace docent::interface
