#pragma once

#include <cstdint>
#include <optional>

#include "runtime/interface/control.h"
#include "runtime/search/index.h"

namespace docent::interface {

/// What choosing something that was found asks for: an exhibit, the nearest of a kind of place, or
/// a place that has a name.
Action meant_by(const Museum& museum, std::uint32_t entry) noexcept;

/// Looks up what visitors type: titles in all languages that staff wrote, numbers and inventory
/// numbers, galleries, kinds of places and their names. Used by one thread.
class Finder {
 public:
  explicit Finder(const Museum& museum) : museum_(museum) {}

  /// Fills `state.found` with what its letters find. The first time it makes the index.
  void look_up(InterfaceState& state);

 private:
  const Museum& museum_;
  std::optional<search::Index> index_;
  search::SearchDesk desk_;
};

}  // namespace docent::interface
