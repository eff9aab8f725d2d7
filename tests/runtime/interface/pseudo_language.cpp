#include "tests/runtime/interface/pseudo_language.h"

#include <algorithm>
#include <array>

namespace docent::test {
namespace {

constexpr std::array<std::string_view, 26> accented_small{
    "á", "ƀ", "ç", "ð", "é", "ƒ", "ĝ", "ĥ", "í", "ĵ", "ķ", "ļ", "ɱ",
    "ñ", "ó", "þ", "ɋ", "ŕ", "š", "ţ", "ú", "ṽ", "ŵ", "ẋ", "ý", "ž"};
constexpr std::array<std::string_view, 26> accented_large{
    "Á", "Ɓ", "Ç", "Ð", "É", "Ƒ", "Ĝ", "Ĥ", "Í", "Ĵ", "Ķ", "Ļ", "Ḿ",
    "Ñ", "Ó", "Þ", "Ɋ", "Ŕ", "Š", "Ţ", "Ú", "Ṽ", "Ŵ", "Ẋ", "Ý", "Ž"};
constexpr std::array<std::string_view, 26> hebrew{"א", "ב", "ג", "ד", "ה", "ו", "ז", "ח", "ט",
                                                  "י", "כ", "ל", "מ", "נ", "ס", "ע", "פ", "צ",
                                                  "ק", "ר", "ש", "ת", "ם", "ן", "ץ", "ף"};

std::string_view letter(Pseudo kind, char c) {
  if (c >= 'a' && c <= 'z')
    return (kind == Pseudo::RightToLeft ? hebrew
                                        : accented_small)[static_cast<std::size_t>(c - 'a')];
  return (kind == Pseudo::RightToLeft ? hebrew : accented_large)[static_cast<std::size_t>(c - 'A')];
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

}  // namespace

std::string in_pseudo(Pseudo kind, std::string_view text) {
  std::string out;
  std::size_t letters = 0;
  bool in_braces = false;
  for (const char c : text) {
    in_braces = c == '{' || (in_braces && c != '}');
    if (is_letter(c) && !in_braces) {
      out += letter(kind, c);
      ++letters;
    } else {
      out += c;
    }
  }
  // Half as long again, in words of five.
  for (std::size_t i = 0; i < letters / 2; ++i) {
    if (i % 5 == 0) out += ' ';
    out += letter(kind, 'o');
  }
  return out;
}

Museum in_pseudo_language(Museum museum, Pseudo kind) {
  static constexpr const char* tag = "qps";  // Of those that ISO 639-2 leaves to whoever needs one.
  const auto english = std::ranges::find(museum.languages, "en", &Language::tag);
  Language language{.tag = tag, .name = in_pseudo(kind, "Pseudo"), .words = {}};
  language.right_to_left = kind == Pseudo::RightToLeft;
  for (const auto& [key, word] : english->words) language.words[key] = in_pseudo(kind, word);
  museum.languages = {language};
  const auto translate = [kind](LocalText& text) {
    const auto found = text.find("en");
    text = found == text.end() ? LocalText{} : LocalText{{tag, in_pseudo(kind, found->second)}};
  };
  translate(museum.title);
  translate(museum.welcome);
  for (Floor& floor : museum.floors) translate(floor.title);
  for (Room& room : museum.rooms) translate(room.title);
  for (Tour& tour : museum.tours) translate(tour.title);
  for (Place& place : museum.places) translate(place.title);
  for (Exhibit& exhibit : museum.exhibits) {
    translate(exhibit.title);
    translate(exhibit.text);
  }
  return museum;
}

}  // namespace docent::test
