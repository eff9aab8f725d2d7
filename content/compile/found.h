#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "runtime/model/museum.h"

namespace docent::compile {

/// How many of each thing a museum has: ("exhibits", 24), ... Only what it may have many of; the
/// names are plural.
std::vector<std::pair<std::string_view, std::size_t>> found_in(const Museum& museum);

/// How many exhibits have a picture of which staff have not said what it shows.
std::size_t undescribed_pictures(const Museum& museum);

/// "24 exhibits, 9 rooms, 2 doors", and behind each that has changed how many there were before:
/// "24 exhibits (23 before)"; and how many pictures have no description.
std::string found_text(const Museum& museum, const Museum* before);

}  // namespace docent::compile
