#include "runtime/interface/places.h"

#include <algorithm>

namespace docent::interface {

std::string word_of(PlaceKind kind) {
  return "place_" + std::string(info_of(kind).name);
}

bool has_place(const Museum& museum, PlaceKind kind) noexcept {
  return std::ranges::any_of(museum.places,
                             [kind](const Place& place) { return answers(place.kind, kind); });
}

std::vector<PlaceKind> kinds_of_places(const Museum& museum) {
  std::vector<PlaceKind> kinds;
  for (const PlaceKindInfo& info : place_kinds)
    if (has_place(museum, info.kind)) kinds.push_back(info.kind);
  return kinds;
}

std::optional<std::uint32_t> only_place(const Museum& museum, PlaceKind kind) noexcept {
  std::optional<std::uint32_t> only;
  for (std::uint32_t i = 0; i < museum.places.size(); ++i) {
    if (!answers(museum.places[i].kind, kind)) continue;
    if (only) return {};
    only = i;
  }
  return only;
}

}  // namespace docent::interface
