#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/interface/control.h"
#include "runtime/search/index.h"

namespace docent::interface {

/// What choosing something that was found asks for: an exhibit, the nearest of a kind of place, a
/// place that has a name; or the exhibits of a gallery, a subject or a period.
Action meant_by(const Museum& museum, std::uint32_t entry) noexcept;

/// A gallery, a subject or a period that exhibits have in common.
struct Group {
  std::string name;                     ///< Of its control.
  std::string_view kind;                ///< Key of the word for what it is.
  const LocalText* title;               ///< Never null.
  std::vector<std::uint32_t> exhibits;  ///< At least one.
};
/// The group that an entry means, which has one.
Group group_of(const Museum& museum, std::uint32_t entry);

/// Looks up what visitors type: titles in all languages that staff wrote, numbers and inventory
/// numbers, galleries, kinds of places and their names. Used by one thread.
class Finder {
 public:
  explicit Finder(const Museum& museum) : museum_(museum) {}

  /// Fills `state.found` with what its letters find; where there are none, with the exhibits that
  /// the visitor looks through, or with all galleries, subjects and periods. The first time that
  /// there are letters it makes the index.
  void look_up(InterfaceState& state);

 private:
  const Museum& museum_;
  std::optional<search::Index> index_;
  search::SearchDesk desk_;
};

}  // namespace docent::interface
