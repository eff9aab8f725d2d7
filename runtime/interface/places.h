#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "runtime/model/exhibit/room_of.h"
#include "runtime/model/museum.h"

namespace docent::interface {

/// The key of the interface's word for a kind: "place_toilets".
std::string word_of(PlaceKind kind);

/// Does the museum have a place that somebody looks for who asks for that kind?
bool has_place(const Museum& museum, PlaceKind kind) noexcept;

/// The kinds that can be asked for, in the order of the table: those of the places, and the wider
/// ones that they answer as well.
std::vector<PlaceKind> kinds_of_places(const Museum& museum);

/// The only place that answers a kind; none where there are several, or none.
std::optional<std::uint32_t> only_place(const Museum& museum, PlaceKind kind) noexcept;

}  // namespace docent::interface
