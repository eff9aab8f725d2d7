#pragma once

#include <cstdint>
#include <string>

#include "runtime/directions/directions.h"
#include "runtime/model/museum.h"

namespace docent::interface {

/// A way as one says it, in at most three sentences. All words and their order come from the
/// language's file (config/words): `door_...`, `way_...`, `ride_...`, `goal_...`,
/// `where_...`, `beside_...`. Names that staff wrote are quoted as they are, so no language has to
/// inflect them.
struct WaySentences {
  std::string way;      ///< "Through “Garden Court”, then the second door on the right."
  std::string goal;     ///< "In “Bronze”, in a glass case on your left."
  std::string figures;  ///< "32 m, about half a minute, step-free."

  bool operator==(const WaySentences&) const = default;
};

/// However long the way is: it says how one sets out, at most three of the rooms that are passed,
/// each change of floors, and the last door.
WaySentences sentences_in(const Museum& museum, std::uint32_t language,
                          const directions::Directions& directions);

/// The same to be spoken: what fills a hole is kept apart (utterance.h), metres and minutes are
/// said in whole words.
WaySentences spoken_sentences_in(const Museum& museum, std::uint32_t language,
                                 const directions::Directions& directions);

/// The text with its first letter as a capital, where the letters have such: Latin, Greek,
/// Cyrillic.
std::string capitalised(std::string text);

}  // namespace docent::interface
