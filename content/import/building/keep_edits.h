#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace docent::import {

/// Something that a second import found between what it wrote last and what is there now.
struct Edit {
  enum class Kind {
    Kept,     ///< Staff's own, which the new plan would have otherwise.
    Changed,  ///< The plan's, which staff have not touched: as the new plan has it.
    Added,    ///< New in the plan.
    Removed,  ///< No longer in the plan, and untouched by staff: taken out.
    Orphan,   ///< No longer in the plan, but staff wrote in it: left.
  };
  Kind kind = Kind::Kept;
  std::size_t line = 0;  ///< From 1, in the new text; 0 where it is not there.
  std::string what;      ///< `title.en of [[room]] foyer`.
};

/// A museum.toml that takes over what the plan has changed and keeps what staff have.
struct MergedToml {
  std::string text;
  std::vector<Edit> edits;
};

/// `base`: what the last import wrote; `mine`: what is there now, by staff's hand; `theirs`: what
/// this import would write. Sections are told apart by their header and their id or name; fields
/// are compared as they are written. Comments and the order of sections are staff's.
MergedToml keep_edits(std::string_view base, std::string_view mine, std::string_view theirs);

}  // namespace docent::import
