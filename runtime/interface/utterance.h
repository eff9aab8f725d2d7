#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "runtime/model/museum.h"

namespace docent::interface {

/// A part of what is said whose sound is made when content is compiled: a label, a title, a text, a
/// number, or what stands between the holes of a sentence. Never empty.
struct SpokenPiece {
  std::string text;    ///< UTF-8; one of spoken_pieces() of the language.
  bool pause = false;  ///< A short silence follows: a phrase ends here.
  float seconds = 0;   ///< How long its sound takes at the usual speed; 0: it has none.

  bool operator==(const SpokenPiece&) const = default;
};

/// What the kiosk says at one go, in one language. Composed on the worker or while loading; the
/// frame thread only picks one.
struct Utterance {
  std::string language;  ///< BCP 47, as in Museum::languages.
  std::vector<SpokenPiece> pieces;

  bool empty() const noexcept { return pieces.empty(); }
  bool operator==(const Utterance&) const = default;
};

/// All that could be said in the language at this index, whatever visitors do: each piece once, in
/// the order of its bytes. Sound is prepared for each of them. Pure: depends on the museum's words,
/// titles and texts alone, so the compiler and the kiosk get the same.
std::vector<std::string> spoken_pieces(const Museum& museum, std::uint32_t language);

/// As a caption or a transcript shows it: pieces as they follow each other, a full stop for a pause
/// where none is written.
std::string text_of(const Utterance& utterance);

/// How long a piece takes at the usual speed, without its pause: as its sound does, or about so
/// long where it has none.
float seconds_of(const SpokenPiece& piece) noexcept;
/// The same of all of it, with its pauses. Where any piece has a sound, those without are not said.
float seconds_of(const Utterance& utterance) noexcept;
/// When it comes to each piece: seconds from its beginning, and then its end.
std::vector<float> begins_of(const Utterance& utterance);
/// Notes how long the museum's sounds are.
void time_pieces(Utterance& utterance, const Museum& museum) noexcept;

/// What stands between the parts of a text that is to be said, such as a sentence and what fills
/// its holes: never in a word of the interface.
inline constexpr char between_pieces = '\x1f';
/// The value for a hole of a sentence, kept apart from the sentence.
std::string apart(std::string_view value);
/// Appends a text, which may hold `between_pieces`, piece by piece. What is not said, such as
/// quotation marks and commas at a piece's ends, is left out. A pause follows.
void append_spoken(Utterance& utterance, std::string_view text);

/// The same of a longer text, whose lines are said one after another.
void append_paragraphs(Utterance& utterance, std::string_view text);

/// Metres and minutes as they are said: in whole phrases, so that each language keeps its plurals.
/// Far distances are rounded, to at most `farthest_spoken`.
std::string spoken_distance(const Museum& museum, std::uint32_t language, double metres);
std::string spoken_time(const Museum& museum, std::uint32_t language, double seconds);
inline constexpr long farthest_spoken = 2000, longest_spoken = 120;  ///< Metres, minutes.

}  // namespace docent::interface
