#pragma once

#include <string>
#include <string_view>

#include "runtime/model/museum.h"

namespace docent::test {

/// A language that nobody speaks and everybody can read: English in letters that English does not
/// have, half as long again. What a view shows in plain letters was forgotten when words were
/// taken out of the program.
enum class Pseudo {
  Accented,    ///< "Ŵéļçóɱé", from left to right.
  RightToLeft  ///< In Hebrew letters.
};

/// `text` in that language. What stands in braces is filled in later and stays.
std::string in_pseudo(Pseudo kind, std::string_view text);

/// The museum with no language but that one: its English words and all that staff wrote.
Museum in_pseudo_language(Museum museum, Pseudo kind);

}  // namespace docent::test
