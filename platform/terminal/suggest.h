#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

namespace docent::terminal {

/// How many letters must be added, removed, changed or swapped with a neighbour to make one word of
/// the other (Damerau 1964, in the form that edits no letter twice). Compares bytes.
std::size_t edit_distance(std::string_view a, std::string_view b);

/// The known word that somebody who wrote `word` probably meant; empty where none is close.
std::string_view closest(std::string_view word, const std::vector<std::string_view>& known);

}  // namespace docent::terminal
