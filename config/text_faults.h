#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace docent::config {

/// A letter that a kiosk cannot show.
struct UnshownLetter {
  std::string name;  ///< "the emoji U+1F3DB".
  std::string hint;
};

/// Which fonts a text is set in: a kiosk's alone, or a museum's own, too, of which only who reads
/// them knows what letters they have.
enum class Fonts : std::uint8_t { Kiosk, Own };

/// The first letter of a text (UTF-8) that no font of a kiosk holds (shown_letters.h), nor may:
/// emoji, letters of private use, control characters, and the mark of a letter that was lost. The
/// answer is the same on every machine, whatever fonts it has.
std::optional<UnshownLetter> unshown_letter(std::string_view text, Fonts fonts = Fonts::Kiosk);

/// Something about a text that visitors would stumble over: "holds the emoji U+1F3DB" and ", which
/// a kiosk has no letters for".
struct TextFault {
  std::string code, what, why, hint;
};

/// How much room a text (UTF-8) takes on a screen, in letters of ordinary width: one of Chinese,
/// Japanese or Korean takes two, a mark above another letter none, and each line break the rest of
/// its line. An estimate that needs no fonts, so the answer is the same on every machine.
std::size_t room_of(std::string_view text);

/// What fits on a screen before it is cut with an ellipsis, even set at 7/10 of its size, measured
/// on 1080 x 1920 and 1920 x 1080 with the largest of the four scripts that are shipped.
inline constexpr std::size_t room_for_title = 80, room_for_text = 500;

/// Letters that no kiosk shows, markup of web pages, letters of a wrong encoding ("CafÃ©" for
/// "Café"), question marks where letters were, and more than there is room for. UTF-8; any bytes
/// are answered.
std::vector<TextFault> faults_of(std::string_view text, Fonts fonts,
                                 std::size_t room = std::numeric_limits<std::size_t>::max());

/// What "CafÃ©" was before its UTF-8 was taken for Windows-1252; empty where that is not what
/// happened.
std::string before_wrong_encoding(std::string_view text);

/// The names in braces that the kiosk fills in: "{n}", "{distance}".
std::set<std::string> placeholders_of(std::string_view text);

}  // namespace docent::config
