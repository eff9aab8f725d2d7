#include "runtime/search/compose.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <utility>

namespace docent::search {
namespace {

void append(std::string& out, char16_t letter) {
  const auto byte = [&](unsigned bits) { out += static_cast<char>(bits); };
  if (letter < 0x80) return byte(letter);
  if (letter < 0x800) {
    byte(0xC0U | letter >> 6U);
  } else {
    byte(0xE0U | letter >> 12U);
    byte(0x80U | (letter >> 6U & 0x3FU));
  }
  byte(0x80U | (letter & 0x3FU));
}

/// Where a letter stands in a table; none where it is not there.
std::optional<std::size_t> place_in(std::u16string_view table, char16_t letter) noexcept {
  const std::size_t place = table.find(letter);
  return place == std::u16string_view::npos ? std::nullopt : std::optional(place);
}

// In the order in which Unicode counts the parts of a syllable.
constexpr std::u16string_view leads = u"ㄱㄲㄴㄷㄸㄹㅁㅂㅃㅅㅆㅇㅈㅉㅊㅋㅌㅍㅎ";
constexpr std::u16string_view vowels = u"ㅏㅐㅑㅒㅓㅔㅕㅖㅗㅘㅙㅚㅛㅜㅝㅞㅟㅠㅡㅢㅣ";
constexpr std::u16string_view tails = u"_ㄱㄲㄳㄴㄵㄶㄷㄹㄺㄻㄼㄽㄾㄿㅀㅁㅂㅄㅅㅆㅇㅈㅊㅋㅌㅍㅎ";

/// Two jamo that are written as one.
struct Join {
  char16_t first, second, both;
};
constexpr std::array doubles{Join{u'ㄱ', u'ㄱ', u'ㄲ'}, Join{u'ㄷ', u'ㄷ', u'ㄸ'},
                             Join{u'ㅂ', u'ㅂ', u'ㅃ'}, Join{u'ㅅ', u'ㅅ', u'ㅆ'},
                             Join{u'ㅈ', u'ㅈ', u'ㅉ'}};
constexpr std::array vowel_joins{
    Join{u'ㅗ', u'ㅏ', u'ㅘ'}, Join{u'ㅗ', u'ㅐ', u'ㅙ'}, Join{u'ㅗ', u'ㅣ', u'ㅚ'},
    Join{u'ㅜ', u'ㅓ', u'ㅝ'}, Join{u'ㅜ', u'ㅔ', u'ㅞ'}, Join{u'ㅜ', u'ㅣ', u'ㅟ'},
    Join{u'ㅡ', u'ㅣ', u'ㅢ'}, Join{u'ㅑ', u'ㅣ', u'ㅒ'}, Join{u'ㅕ', u'ㅣ', u'ㅖ'}};
constexpr std::array tail_joins{
    Join{u'ㄱ', u'ㄱ', u'ㄲ'}, Join{u'ㄱ', u'ㅅ', u'ㄳ'}, Join{u'ㄴ', u'ㅈ', u'ㄵ'},
    Join{u'ㄴ', u'ㅎ', u'ㄶ'}, Join{u'ㄹ', u'ㄱ', u'ㄺ'}, Join{u'ㄹ', u'ㅁ', u'ㄻ'},
    Join{u'ㄹ', u'ㅂ', u'ㄼ'}, Join{u'ㄹ', u'ㅅ', u'ㄽ'}, Join{u'ㄹ', u'ㅌ', u'ㄾ'},
    Join{u'ㄹ', u'ㅍ', u'ㄿ'}, Join{u'ㄹ', u'ㅎ', u'ㅀ'}, Join{u'ㅂ', u'ㅅ', u'ㅄ'},
    Join{u'ㅅ', u'ㅅ', u'ㅆ'}};

template <std::size_t count>
char16_t joined(const std::array<Join, count>& joins, char16_t first, char16_t second) noexcept {
  for (const Join& join : joins)
    if (join.first == first && join.second == second) return join.both;
  return 0;
}

/// Puts jamo together as they come, as a keyboard of two sets does.
class Syllables {
 public:
  explicit Syllables(std::string& out) : out_(out) {}

  /// False where the letter is no jamo: then all that was before is written.
  bool take(char16_t letter) {
    if (place_in(vowels, letter)) {
      take_vowel(letter);
      return true;
    }
    if (place_in(leads, letter)) {
      take_consonant(letter);
      return true;
    }
    write();
    return false;
  }
  void write();

 private:
  void take_consonant(char16_t letter);
  void take_vowel(char16_t letter);

  std::string& out_;
  char16_t lead_ = 0, vowel_ = 0, tail_ = 0;
};

void Syllables::write() {
  const auto lead = place_in(leads, lead_), vowel = place_in(vowels, vowel_);
  if (lead && vowel) {
    const std::size_t tail = place_in(tails, tail_).value_or(0);
    append(out_, static_cast<char16_t>(0xAC00 + (*lead * 21 + *vowel) * 28 + tail));
  } else {
    for (const char16_t jamo : {lead_, vowel_})
      if (jamo != 0) append(out_, jamo);
  }
  lead_ = vowel_ = tail_ = 0;
}

void Syllables::take_consonant(char16_t letter) {
  if (lead_ != 0 && vowel_ != 0) {
    const char16_t tail = tail_ == 0 ? letter : joined(tail_joins, tail_, letter);
    if (tail != 0 && place_in(tails, tail)) {
      tail_ = tail;
      return;
    }
  }
  const char16_t twice = vowel_ == 0 ? joined(doubles, lead_, letter) : char16_t{0};
  if (twice == 0) write();
  lead_ = twice == 0 ? letter : twice;
}

/// A last consonant before a vowel is that vowel's first.
void Syllables::take_vowel(char16_t letter) {
  if (tail_ != 0) {
    char16_t next = tail_;
    tail_ = 0;
    for (const Join& join : tail_joins)
      if (join.both == next) {
        tail_ = join.first;
        next = join.second;
        break;
      }
    write();
    lead_ = next;
  } else if (vowel_ != 0) {
    const char16_t both = joined(vowel_joins, vowel_, letter);
    if (both != 0) {
      vowel_ = both;
      return;
    }
    write();
  }
  vowel_ = letter;
}

/// The sign of a vowel of Devanagari after a consonant; 0 where the vowel stays as it is.
char16_t sign_of(char16_t before, char16_t vowel) noexcept {
  constexpr std::u16string_view whole = u"आइईउऊऋएऐओऔ",
                                signs =
                                    u"\u093E\u093F\u0940\u0941\u0942\u0943\u0947\u0948\u094B\u094C";
  if (before < u'क' || before > u'ह') return 0;
  const auto place = place_in(whole, vowel);
  return place ? signs[*place] : char16_t{0};
}

/// A kana with the mark that follows it; 0 where they make no letter.
char16_t voiced(char16_t kana, char16_t mark) noexcept {
  constexpr std::u16string_view plain = u"うかきくけこさしすせそたちつてとはひふへほ",
                                voice = u"ゔがぎぐげござじずぜぞだぢづでどばびぶべぼ",
                                puffs = u"はひふへほ", puffed = u"ぱぴぷぺぽ";
  const bool is_voice = mark == u'゛';
  if (!is_voice && mark != u'゜') return 0;
  const auto place = place_in(is_voice ? plain : puffs, kana);
  return !place ? char16_t{0} : (is_voice ? voice : puffed)[*place];
}

}  // namespace

std::string utf8_of(char16_t letter) {
  std::string out;
  append(out, letter);
  return out;
}

std::string composed(std::u16string_view typed) {
  std::string out;
  Syllables syllables(out);
  for (std::size_t i = 0; i < typed.size(); ++i) {
    char16_t letter = typed[i];
    if (syllables.take(letter)) continue;
    const char16_t next = i + 1 < typed.size() ? typed[i + 1] : char16_t{0};
    if (const char16_t kana = voiced(letter, next); kana != 0) {
      letter = kana;
      ++i;
    } else if (const char16_t sign = i > 0 ? sign_of(typed[i - 1], letter) : char16_t{0};
               sign != 0) {
      letter = sign;
    }
    append(out, letter);
  }
  syllables.write();
  return out;
}

}  // namespace docent::search
