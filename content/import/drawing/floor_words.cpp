#include "content/import/drawing/floor_words.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <string>
#include <utility>
#include <vector>

#include "content/import/drawing/lower_case.h"

namespace docent::import {
namespace {

using std::string_view;

/// A run of letters, or a number with its sign.
struct Word {
  std::string text;
  std::optional<int> number{};
};

/// Accents and sharp letters as their plain ones: `étage` is `etage`.
std::string plain(string_view text) {
  static constexpr std::array<std::pair<string_view, string_view>, 40> plainer{{
      {"à", "a"}, {"á", "a"}, {"â", "a"}, {"ä", "a"}, {"å", "a"}, {"ã", "a"}, {"æ", "ae"},
      {"ç", "c"}, {"è", "e"}, {"é", "e"}, {"ê", "e"}, {"ë", "e"}, {"ì", "i"}, {"í", "i"},
      {"î", "i"}, {"ñ", "n"}, {"ò", "o"}, {"ó", "o"}, {"ô", "o"}, {"ö", "o"}, {"õ", "o"},
      {"ø", "o"}, {"ù", "u"}, {"ú", "u"}, {"û", "u"}, {"ü", "u"}, {"ý", "y"}, {"ß", "ss"},
      {"É", "e"}, {"È", "e"}, {"Ä", "a"}, {"Ö", "o"}, {"Ü", "u"}, {"Å", "a"}, {"Ø", "o"},
      {"ě", "e"}, {"ř", "r"}, {"ž", "z"}, {"í", "i"}, {"ę", "e"},
  }};
  std::string out = lower_case(text);
  for (const auto& [letter, base] : plainer)
    for (std::size_t at = out.find(letter); at != std::string::npos; at = out.find(letter, at))
      out.replace(at, letter.size(), base);
  return out;
}

std::vector<Word> words_of(string_view text) {
  const std::string small = plain(text);
  std::vector<Word> words;
  const auto is = [&](std::size_t i, int (*test)(int)) {
    return i < small.size() && test(static_cast<unsigned char>(small[i])) != 0;
  };
  for (std::size_t i = 0; i < small.size();) {
    const std::size_t begin = i;
    if (is(i, std::isdigit)) {
      while (is(i, std::isdigit)) ++i;
      if (i + 1 < small.size() && (small[i] == '.' || small[i] == ',') && is(i + 1, std::isdigit)) {
        ++i;  // A height in metres counts no floors.
        while (is(i, std::isdigit)) ++i;
        words.push_back({"height", {}});
        continue;
      }
      int number = 0;
      std::from_chars(small.data() + begin, small.data() + i, number);
      // A minus belongs to the number unless it parts two words: `Level -1`, but `level-1`.
      const bool minus = begin > 0 && small[begin - 1] == '-' &&
                         (begin == 1 || small[begin - 2] == ' ' || small[begin - 2] == '_' ||
                          small[begin - 2] == '-');
      words.push_back({small.substr(begin, i - begin), minus ? -number : number});
      continue;
    }
    const auto letter = [&](std::size_t at) {
      return at < small.size() &&
             (is(at, std::isalpha) || static_cast<unsigned char>(small[at]) >= 0x80);
    };
    if (!letter(i)) {
      ++i;
      continue;
    }
    while (letter(i)) ++i;
    words.push_back({small.substr(begin, i - begin), {}});
  }
  return words;
}

bool holds_any(const std::string& text, std::initializer_list<string_view> parts) {
  return std::ranges::any_of(
      parts, [&](string_view part) { return text.find(part) != std::string::npos; });
}

bool is_any(const std::string& word, std::initializer_list<string_view> words) {
  return std::ranges::find(words, word) != words.end();
}

/// Words that, beside a number, speak of floors.
bool is_floor_word(const std::string& word) {
  return is_any(word, {"og",     "ug",     "floor",    "level",        "lvl",       "lv",
                       "storey", "story",  "geschoss", "obergeschoss", "etage",     "niveau",
                       "nivel",  "planta", "piso",     "piano",        "livello",   "verdieping",
                       "vaning", "kat",    "emelet",   "pietro",       "podlazi",   "patro",
                       "kerros", "andar",  "floors",   "stock",        "stockwerk", "untergeschoss",
                       "f",      "l"}) ||
         holds_any(word, {"этаж", "层", "階", "층"});
}

std::optional<int> ordinal_word(const std::string& word) {
  static constexpr std::array<std::pair<string_view, int>, 46> ordinals{{
      {"first", 1},     {"second", 2},    {"third", 3},   {"fourth", 4},   {"fifth", 5},
      {"sixth", 6},     {"erstes", 1},    {"zweites", 2}, {"drittes", 3},  {"viertes", 4},
      {"erster", 1},    {"zweiter", 2},   {"dritter", 3}, {"premier", 1},  {"deuxieme", 2},
      {"troisieme", 3}, {"quatrieme", 4}, {"primera", 1}, {"segunda", 2},  {"tercera", 3},
      {"cuarta", 4},    {"primer", 1},    {"segundo", 2}, {"tercer", 3},   {"primo", 1},
      {"secondo", 2},   {"terzo", 3},     {"quarto", 4},  {"primeiro", 1}, {"terceiro", 3},
      {"eerste", 1},    {"tweede", 2},    {"derde", 3},   {"forsta", 1},   {"andra", 2},
      {"tredje", 3},    {"первый", 1},    {"второй", 2},  {"третий", 3},   {"birinci", 1},
      {"ikinci", 2},    {"ucuncu", 3},    {"一", 1},      {"二", 2},       {"三", 3},
      {"四", 4},
  }};
  for (const auto& [text, number] : ordinals)
    if (text == word) return number;
  for (const auto& [text, number] : {std::pair<string_view, int>{"一层", 1},
                                     {"二层", 2},
                                     {"三层", 3},
                                     {"四层", 4},
                                     {"一階", 1},
                                     {"二階", 2},
                                     {"三階", 3}})
    if (word.find(text) != std::string::npos) return number;
  return std::nullopt;
}

bool speaks_of_ground(const std::string& whole, const std::vector<Word>& words) {
  if (holds_any(whole, {"ground", "erdgesch", "rez de chauss", "rez-de-chauss", "planta baja",
                        "pianoterra", "piano terra", "begane grond", "bottenvaning", "stueetage",
                        "zemin", "foldszint", "prizemi", "parterre", "首层", "地面层", "térreo",
                        "terreo", "цокол"}))
    return true;
  return std::ranges::any_of(words, [](const Word& word) {
    return is_any(word.text, {"eg", "rdc", "gf", "pb", "parter", "lobby"});
  });
}

bool speaks_of_basement(const std::string& whole, const std::vector<Word>& words) {
  if (holds_any(whole, {"basement", "keller", "untergesch", "sous sol", "sous-sol", "souterrain",
                        "sotano", "semisotano", "kelder", "подвал", "seminterrato", "interrato",
                        "地下", "suterren", "piwnica", "pince"}))
    return true;
  return std::ranges::any_of(words, [](const Word& word) { return word.text == "ug"; });
}

}  // namespace

std::optional<double> floor_said(string_view text) {
  if (text.size() > 120) return std::nullopt;
  const std::vector<Word> words = words_of(text);
  const std::string whole = plain(text);
  std::optional<int> number;
  bool basement = speaks_of_basement(whole, words);
  for (std::size_t i = 0; i < words.size() && !number; ++i) {
    // A number beside a word for floors, with at most `er`, `nd`, `eme` between.
    if (is_floor_word(words[i].text)) {
      if (i + 1 < words.size() && words[i + 1].number)
        number = words[i + 1].number;
      else if (i > 0 && words[i - 1].number)
        number = words[i - 1].number;
      else if (i > 1 && words[i - 2].number && words[i - 1].text.size() <= 4)
        number = words[i - 2].number;
      else if (i > 0)
        number = ordinal_word(words[i - 1].text);
      if (!number && i + 1 < words.size()) number = ordinal_word(words[i + 1].text);
    } else if (holds_any(words[i].text, {"一层", "二层", "三层", "四层", "一階", "二階", "三階"})) {
      number = ordinal_word(words[i].text);
    } else if (words[i].text == "b" && i + 1 < words.size() && words[i + 1].number &&
               words.size() <= 4) {
      basement = true;
      number = words[i + 1].number;
    } else if (basement && words[i].number && words.size() <= 3) {
      number = words[i].number;
    }
  }
  if (speaks_of_ground(whole, words) && !basement) return 0;
  if (basement) return number && *number != 0 ? -std::abs(*number) : -1;
  if (!number || std::abs(*number) > 150) return std::nullopt;
  return *number;
}

}  // namespace docent::import
