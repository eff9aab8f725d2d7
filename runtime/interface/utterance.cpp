#include "runtime/interface/utterance.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>

#include "runtime/interface/control.h"
#include "runtime/interface/keyboard.h"
#include "runtime/interface/phrases.h"
#include "runtime/interface/plural.h"

namespace docent::interface {
namespace {

/// What stands at a piece's ends without being said.
constexpr std::array<std::string_view, 28> silent{
    " ", "\u00a0", "\u202f", "\n", "\t", ",", ".",  ":",  ";",  "\"", "·",  "“",  "”",  "„",
    "‘", "’",      "«",      "»",  "‹",  "›", "「", "」", "『", "』", "、", "。", "，", "،"};

std::string_view without_silent_ends(std::string_view text) noexcept {
  for (bool goes_on = true; goes_on;) {
    goes_on = false;
    for (const std::string_view mark : silent) {
      if (text.starts_with(mark)) {
        text.remove_prefix(mark.size());
        goes_on = true;
      }
      if (text.ends_with(mark)) {
        text.remove_suffix(mark.size());
        goes_on = true;
      }
    }
  }
  return text;
}

/// Calls `take` with each piece of a text.
template <typename Take>
void for_each_piece(std::string_view text, const Take& take) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(between_pieces), text.size());
    if (const std::string_view piece = without_silent_ends(text.substr(0, end)); !piece.empty())
      take(piece);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

/// The distance that is said for one: exact when near, coarse when far.
long rounded_distance(double metres) noexcept {
  const long whole = std::clamp(std::lround(std::min(metres, 1e6)), 1L, farthest_spoken);
  const auto to = [whole](long step) { return (whole + step / 2) / step * step; };
  return whole <= 20 ? whole : whole <= 100 ? to(5) : whole <= 1000 ? to(50) : to(100);
}

std::string said_distance(const Museum& museum, std::uint32_t language, long metres) {
  const std::string_view form = plural_form(language_tag(museum, language), metres);
  return filled_in(word(museum, language, fmt::format("metres_{}", form)), "n",
                   fmt::format("{}", metres));
}

/// Words that are shown and never said: staff's, of a shared glass, of a calendar and a clock.
bool is_silent_word(std::string_view key) noexcept {
  constexpr std::array<std::string_view, 5> families{"staff_", "month_", "weekday_", "look_",
                                                     "minutes_"};
  constexpr std::array<std::string_view, 15> single{
      "digits",     "north", "clock",        "clock_hour",   "before_noon",
      "after_noon", "noon",  "date",         "date_of_year", "day_and_clock",
      "tomorrow",   "join",  "closed_until", "join_where",   "all_taken"};
  return std::ranges::any_of(families, [&](auto family) { return key.starts_with(family); }) ||
         std::ranges::find(single, key) != single.end();
}

/// Gathers pieces, each once.
class Gatherer {
 public:
  Gatherer(const Museum& museum, std::uint32_t language) : museum_(museum), language_(language) {}

  void add(std::string_view text) {
    for_each_piece(text, [this](std::string_view piece) { pieces.emplace(piece); });
  }
  void add(const LocalText& text) { add(in_language(museum_, language_, text)); }
  /// What a word says between its holes; where it is filled with a number or an ordinal that makes
  /// one piece with it, each of these.
  void add_word(std::string_view key) {
    std::string text(word(museum_, language_, key));
    if (text.find("{nth}") != std::string::npos) {
      for (int nth = 1; nth <= 9; ++nth)
        add(filled_in(text, "nth", word(museum_, language_, fmt::format("door_nth_{}", nth))));
      return;
    }
    bool is_hole = false;
    for (char& c : text) {
      if (c == '{') is_hole = true;
      const bool ends = c == '}';
      if (is_hole) c = between_pieces;
      if (ends) is_hole = false;
    }
    add(text);
  }
  void add_words();
  void add_numbers();
  void add_names();
  void add_letters();
  std::set<std::string, std::less<>> pieces;

 private:
  const Museum& museum_;
  std::uint32_t language_;
};

void Gatherer::add_words() {
  for (const std::uint32_t from : {language_, 0U})  // a word that is missing is said in the first
    if (from < museum_.languages.size())
      for (const auto& [key, text] : museum_.languages[from].words)
        if (!is_silent_word(key)) add_word(key);
}

void Gatherer::add_numbers() {
  const std::size_t most = std::max<std::size_t>(
      {20, museum_.exhibits.size() + museum_.tours.size(), museum_.places.size()});
  for (std::size_t n = 0; n <= most; ++n) add(fmt::format("{}", n));
  for (long metres = 1; metres <= farthest_spoken; ++metres)
    if (rounded_distance(static_cast<double>(metres)) == metres)
      add(said_distance(museum_, language_, metres));
  for (long minutes = 0; minutes <= longest_spoken; ++minutes)
    add(spoken_time(museum_, language_, static_cast<double>(60 * minutes)));
}

void Gatherer::add_names() {
  add(museum_.title);
  add(museum_.welcome);
  if (language_ < museum_.languages.size()) add(museum_.languages[language_].name);
  for (const Floor& floor : museum_.floors) {
    add(floor.title);
    add(floor.plan.name);
    add(floor.plan.short_name);
  }
  for (const Room& room : museum_.rooms) add(room.title);
  for (const Place& place : museum_.places) add(place.title);
  for (const WayOffer& way : museum_.ways) add(way.title);
  for (const Tour& tour : museum_.tours) add(title_in(museum_, language_, tour, Digits::Plain));
  for (const Exhibit& exhibit : museum_.exhibits) {
    add(exhibit.title);
    add(exhibit.description);
    add(exhibit.text);
    for_each_line(in_language(museum_, language_, exhibit.more),
                  [this](std::string_view line) { add(line); });
    add(exhibit.subject);
    add(exhibit.period);
  }
  for (const ExhibitSound& sound : museum_.sounds) add(sound.title);
  for (const FurtherPicture& picture : museum_.pictures) {
    add(picture.caption);
    add(picture.description);
  }
}

/// The keys of the language, and of any that a visitor may have typed in before.
void Gatherer::add_letters() {
  if (language_ >= museum_.languages.size()) return;
  for (const std::u16string_view row : keyboard_of(museum_.languages[language_].tag).rows)
    for (const char16_t letter : row) add(said_of(letter));
}

}  // namespace

std::vector<std::string> spoken_pieces(const Museum& museum, std::uint32_t language) {
  Gatherer gatherer(museum, language);
  gatherer.add_words();
  gatherer.add_numbers();
  gatherer.add_names();
  gatherer.add_letters();
  return {gatherer.pieces.begin(), gatherer.pieces.end()};
}

std::string text_of(const Utterance& utterance) {
  constexpr std::array<std::string_view, 6> ends{".", "?", "!", "？", "！", "…"};
  std::string text;
  for (const SpokenPiece& piece : utterance.pieces) {
    if (!text.empty()) text += ' ';
    text += piece.text;
    const bool has_end =
        std::ranges::any_of(ends, [&](std::string_view end) { return text.ends_with(end); });
    if (piece.pause && !has_end) text += '.';
  }
  return text;
}

namespace {

constexpr float start_seconds = 0.2F, pause_seconds = 0.25F;

bool has_sound(const Utterance& utterance) noexcept {
  return std::ranges::any_of(utterance.pieces,
                             [](const SpokenPiece& piece) { return piece.seconds > 0; });
}

/// With its pause.
float seconds_within(const SpokenPiece& piece, bool others_sound) noexcept {
  const float own = others_sound ? piece.seconds : seconds_of(piece);
  return own + (piece.pause ? pause_seconds : 0);
}

}  // namespace

float seconds_of(const SpokenPiece& piece) noexcept {
  constexpr float letter = 0.06F, sign = 0.14F;  // signs that are a syllable take longer
  if (piece.seconds > 0) return piece.seconds;
  float seconds = 0;
  for (const char c : piece.text) {
    const auto byte = static_cast<unsigned char>(c);
    if ((byte & 0xC0U) != 0x80U) seconds += byte >= 0xE0U ? sign : letter;
  }
  return seconds;
}

float seconds_of(const Utterance& utterance) noexcept {
  const bool sounds = has_sound(utterance);
  float seconds = start_seconds;
  for (const SpokenPiece& piece : utterance.pieces) seconds += seconds_within(piece, sounds);
  return seconds;
}

std::vector<float> begins_of(const Utterance& utterance) {
  const bool sounds = has_sound(utterance);
  std::vector<float> begins{start_seconds};
  for (const SpokenPiece& piece : utterance.pieces)
    begins.push_back(begins.back() + seconds_within(piece, sounds));
  return begins;
}

void time_pieces(Utterance& utterance, const Museum& museum) noexcept {
  const auto language = std::ranges::find(museum.languages, utterance.language, &Language::tag);
  const auto index = static_cast<std::uint32_t>(language - museum.languages.begin());
  for (SpokenPiece& piece : utterance.pieces)
    if (const SpeechSound* sound = find_sound(museum.speech, index, piece.text); sound != nullptr)
      piece.seconds = static_cast<float>(sound->samples) / static_cast<float>(SpeechSound::rate);
}

std::string apart(std::string_view value) {
  return fmt::format("{}{}{}", between_pieces, value, between_pieces);
}

void append_spoken(Utterance& utterance, std::string_view text) {
  const std::size_t before = utterance.pieces.size();
  for_each_piece(text, [&](std::string_view piece) {
    utterance.pieces.push_back({.text = std::string(piece)});
  });
  if (utterance.pieces.size() > before) utterance.pieces.back().pause = true;
}

void append_paragraphs(Utterance& utterance, std::string_view text) {
  for_each_line(text, [&](std::string_view line) { append_spoken(utterance, line); });
}

std::string spoken_distance(const Museum& museum, std::uint32_t language, double metres) {
  return said_distance(museum, language, rounded_distance(metres));
}

std::string spoken_time(const Museum& museum, std::uint32_t language, double seconds) {
  return time_in(museum, language, std::min(seconds, 60.0 * longest_spoken), Digits::Plain);
}

}  // namespace docent::interface
