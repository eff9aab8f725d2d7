#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "config/museum_config.h"

namespace docent::command {

/// A text of a museum that is written once in each language.
struct MuseumText {
  std::string id;       ///< "jade-disc.title", "room.hall.title", "words.home".
  std::string what;     ///< "title" or "text" or "welcome": the key that holds it, empty of words.
  std::string exhibit;  ///< The exhibit's id, where it is of one.
  config::Place owner;  ///< The exhibit's id, else the section.
  const config::LocatedTexts* texts = nullptr;
};

/// All of them, in the order of the files. Borrows from `config`.
std::vector<MuseumText> museum_texts(const config::MuseumConfig& config);

/// What is written in a language; null where nothing is, and where another language's text only
/// stands in for it.
const config::Located<std::string>* written_in(const MuseumText& text, std::string_view language);

}  // namespace docent::command
