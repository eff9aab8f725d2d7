#include "runtime/search/fold.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace docent::search {
namespace {

constexpr char16_t unchanged = u'*';  ///< In a table: the letter stays as it is.

/// What consecutive letters fold to, one for each, from `first`.
struct LetterRow {
  char32_t first;
  std::u16string_view to;
};

// From Unicode's decompositions and case foldings, without the marks. Latin-1 and Latin Extended-A
// and -B, Greek, Latin Extended Additional, Greek Extended; hiragana without voice and size, and
// half-width katakana as hiragana.
constexpr std::array letter_rows{
    LetterRow{U'\u00C0',
              u"aaaaaa*ceeeeiiiidnooooo*ouuuuy*saaaaaa*ceeeeiiiidnooooo*ouuuuy*y"
              u"aaaaaaccccccccddddeeeeeeeeeegggggggghhhhiiiiiiiiiiiijjkkklllllll"
              u"lllnnnnnn*nnoooooo**rrrrrrssssssssttttttuuuuuuuuuuuuwwyyyzzzzzzs"
              u"bbbb**occdddd*eeeffg**iikkl**nnooo**pp*****ttttuu**yyzz*********"
              u"****dddlllnnnaaiioouuuuuuuuuueaaaa**ggggkkoooo**jdddgg**nnaa**oo"
              u"aaaaeeeeiiiioooorrrruuuusstt**hhn*****aaeeooooooooyy***j*****l*s"
              u"z**bu*eejjqqrryy"},
    LetterRow{U'\u0370',
              u"**********************α*εηι*ο*υωιαβγδεζηθικλμνξοπρ*στυφχψωιυαεηι"
              u"υαβγδεζηθικλμνξοπρσστυφχψωιυουω*βθυυυφπ*************************"
              u"κρσ*θε***σ******"},
    LetterRow{U'\u1E00',
              u"aabbbbbbccddddddddddeeeeeeeeeeffgghhhhhhhhhhiiiikkkkkkllllllllmm"
              u"mmmmnnnnnnnnoooooooopppprrrrrrrrssssssssssttttttttuuuuuuuuuuvvvv"
              u"wwwwwwwwwwxxxxyyzzzzzzhtwyas**s*aaaaaaaaaaaaaaaaaaaaaaaaeeeeeeee"
              u"eeeeeeeeiiiioooooooooooooooooooooooouuuuuuuuuuuuuuyyyyyyyy******"},
    LetterRow{U'\u1F00',
              u"ααααααααααααααααεεεεεε**εεεεεε**ηηηηηηηηηηηηηηηηιιιιιιιιιιιιιιιι"
              u"οοοοοο**οοοοοο**υυυυυυυυ*υ*υ*υ*υωωωωωωωωωωωωωωωωααεεηηιιοουυωω**"
              u"ααααααααααααααααηηηηηηηηηηηηηηηηωωωωωωωωωωωωωωωωααααα*ααααααα*ι*"
              u"**ηηη*ηηεεηηη***ιιιι**ιιιιιι****υυυυρρυυυυυυρ*****ωωω*ωωοοωωω***"},
    LetterRow{U'\u3041',
              u"ああいいううええおおかかききくくけけここささししすすせせそそたたちちつつつててとと"
              u"なにぬねのはははひひひふふふへへへほほほまみむ"
              u"めもややゆゆよよらりるれろわわゐゑをんうかけ"},
    LetterRow{U'\uFF66',
              u"をあいうえおやゆよつ*"
              u"あいうえおかきくけこさしすせそたちつてとなにぬねのはひふへほまみむめもやゆよらりる"
              u"れろわん**"},
};

/// Letters that fold to others than such a row says: Latin ligatures; Cyrillic; Arabic's forms of
/// alef, yeh, waw and teh marbuta, and Persian's; Hebrew's finals; Devanagari's signs, which fold
/// to the vowels that they stand for, and long vowels to short ones, because people mix them up.
struct Pair {
  char32_t from;
  std::u16string_view to;
};
constexpr std::array pairs{
    Pair{U'\u00C6', u"ae"},     Pair{U'\u00DE', u"th"},     Pair{U'\u00DF', u"ss"},
    Pair{U'\u00E6', u"ae"},     Pair{U'\u00FE', u"th"},     Pair{U'\u0152', u"oe"},
    Pair{U'\u0153', u"oe"},     Pair{U'\u1E9E', u"ss"},     Pair{U'Ѐ', u"е"},
    Pair{U'Ё', u"е"},           Pair{U'Ђ', u"д"},           Pair{U'Ѓ', u"г"},
    Pair{U'Є', u"е"},           Pair{U'Ѕ', u"з"},           Pair{U'І', u"и"},
    Pair{U'Ї', u"и"},           Pair{U'Ј', u"и"},           Pair{U'Ў', u"у"},
    Pair{U'Й', u"и"},           Pair{U'Ъ', u"ь"},           Pair{U'й', u"и"},
    Pair{U'ъ', u"ь"},           Pair{U'ѐ', u"е"},           Pair{U'ё', u"е"},
    Pair{U'ђ', u"д"},           Pair{U'ѓ', u"г"},           Pair{U'є', u"е"},
    Pair{U'ѕ', u"з"},           Pair{U'і', u"и"},           Pair{U'ї', u"и"},
    Pair{U'ј', u"и"},           Pair{U'ў', u"у"},           Pair{U'Ґ', u"г"},
    Pair{U'ґ', u"г"},           Pair{U'ך', u"כ"},           Pair{U'ם', u"מ"},
    Pair{U'ן', u"נ"},           Pair{U'ף', u"פ"},           Pair{U'ץ', u"צ"},
    Pair{U'\u0621', u""},       Pair{U'\u0622', u"\u0627"}, Pair{U'\u0623', u"\u0627"},
    Pair{U'\u0624', u"\u0648"}, Pair{U'\u0625', u"\u0627"}, Pair{U'\u0626', u"\u064A"},
    Pair{U'\u0629', u"\u0647"}, Pair{U'\u0649', u"\u064A"}, Pair{U'\u0671', u"\u0627"},
    Pair{U'\u06A9', u"\u0643"}, Pair{U'\u06CC', u"\u064A"}, Pair{U'ई', u"इ"},
    Pair{U'ऊ', u"उ"},           Pair{U'\u0901', u"\u0902"}, Pair{U'\u0929', u"न"},
    Pair{U'\u0931', u"र"},      Pair{U'\u093E', u"आ"},      Pair{U'\u093F', u"इ"},
    Pair{U'\u0940', u"इ"},      Pair{U'\u0941', u"उ"},      Pair{U'\u0942', u"उ"},
    Pair{U'\u0943', u"ऋ"},      Pair{U'\u0945', u"ए"},      Pair{U'\u0947', u"ए"},
    Pair{U'\u0948', u"ऐ"},      Pair{U'\u0949', u"ओ"},      Pair{U'ऑ', u"ओ"},
    Pair{U'\u094B', u"ओ"},      Pair{U'\u094C', u"औ"},      Pair{U'\u0958', u"क"},
    Pair{U'\u0959', u"ख"},      Pair{U'\u095A', u"ग"},      Pair{U'\u095B', u"ज"},
    Pair{U'\u095C', u"ड"},      Pair{U'\u095D', u"ढ"},      Pair{U'\u095E', u"फ"},
    Pair{U'\u095F', u"य"},      Pair{U'\u0E33', u"\u0E32"},
};

/// What is left out: accents that stand alone, points and vowel signs, tones, lengths, apostrophes.
struct Range {
  char32_t first, last;
};
constexpr std::array silent{
    Range{U'\'', U'\''},         Range{U'`', U'`'},           Range{U'\u00AD', U'\u00AD'},
    Range{U'\u00B4', U'\u00B4'}, Range{U'\u02B0', U'\u036F'}, Range{U'\u0483', U'\u0489'},
    Range{U'\u0591', U'\u05BD'}, Range{U'\u05BF', U'\u05C7'}, Range{U'\u05F3', U'\u05F4'},
    Range{U'\u0610', U'\u061A'}, Range{U'\u0640', U'\u0640'}, Range{U'\u064B', U'\u065F'},
    Range{U'\u0670', U'\u0670'}, Range{U'\u06D6', U'\u06ED'}, Range{U'\u093C', U'\u093D'},
    Range{U'\u094D', U'\u094D'}, Range{U'\u0E3A', U'\u0E3A'}, Range{U'\u0E47', U'\u0E4E'},
    Range{U'\u1AB0', U'\u1AFF'}, Range{U'\u200B', U'\u200F'}, Range{U'\u2018', U'\u201B'},
    Range{U'\u202A', U'\u202E'}, Range{U'\u2060', U'\u206F'}, Range{U'\u3099', U'\u309C'},
    Range{U'\u30FC', U'\u30FC'}, Range{U'\uFE00', U'\uFE0F'}, Range{U'\uFEFF', U'\uFEFF'},
    Range{U'\uFF70', U'\uFF70'}, Range{U'\uFF9E', U'\uFF9F'},
};

/// Ten digits from each of these.
constexpr std::array zeros{U'\u0660', U'\u06F0', U'\u0966', U'\u0E50', U'\uFF10'};

/// What stands between words.
constexpr std::array gaps{
    Range{U'\0', U'/'},          Range{U':', U'@'},           Range{U'[', U'_'},
    Range{U'{', U'\u00BF'},      Range{U'\u00D7', U'\u00D7'}, Range{U'\u00F7', U'\u00F7'},
    Range{U'\u05BE', U'\u05BE'}, Range{U'\u060C', U'\u060D'}, Range{U'\u061B', U'\u061F'},
    Range{U'\u0964', U'\u0965'}, Range{U'\u0E2F', U'\u0E2F'}, Range{U'\u2000', U'\u206F'},
    Range{U'\u3000', U'\u3004'}, Range{U'\u3007', U'\u3020'}, Range{U'\u30A0', U'\u30A0'},
    Range{U'\u30FB', U'\u30FB'}, Range{U'\uFF5F', U'\uFF65'}, Range{U'\uFFFD', U'\uFFFD'},
};

bool among(std::span<const Range> ranges, char32_t letter) noexcept {
  return std::ranges::any_of(ranges,
                             [&](const Range& r) { return letter >= r.first && letter <= r.last; });
}

Folded just(char16_t letter) noexcept {
  return {.letters = {letter}, .count = 1};
}

Folded these(std::u16string_view letters) noexcept {
  Folded folded;
  for (const char16_t letter : letters) folded.letters[folded.count++] = letter;
  return folded;
}

// Hangul: a syllable is made of a first consonant, a vowel and perhaps a last consonant. Each is
// taken apart into the keys that one presses for it, so that what is half typed finds.
constexpr std::array<std::u16string_view, 19> lead_keys{
    u"ㄱ",   u"ㄱㄱ", u"ㄴ", u"ㄷ",   u"ㄷㄷ", u"ㄹ", u"ㅁ", u"ㅂ", u"ㅂㅂ", u"ㅅ",
    u"ㅅㅅ", u"ㅇ",   u"ㅈ", u"ㅈㅈ", u"ㅊ",   u"ㅋ", u"ㅌ", u"ㅍ", u"ㅎ"};
constexpr std::array<std::u16string_view, 21> vowel_keys{
    u"ㅏ",   u"ㅐ", u"ㅑ", u"ㅑㅣ", u"ㅓ",   u"ㅔ",   u"ㅕ", u"ㅕㅣ", u"ㅗ",   u"ㅗㅏ", u"ㅗㅐ",
    u"ㅗㅣ", u"ㅛ", u"ㅜ", u"ㅜㅓ", u"ㅜㅔ", u"ㅜㅣ", u"ㅠ", u"ㅡ",   u"ㅡㅣ", u"ㅣ"};
constexpr std::array<std::u16string_view, 28> tail_keys{
    u"",     u"ㄱ",   u"ㄱㄱ", u"ㄱㅅ", u"ㄴ",   u"ㄴㅈ", u"ㄴㅎ", u"ㄷ", u"ㄹ",   u"ㄹㄱ",
    u"ㄹㅁ", u"ㄹㅂ", u"ㄹㅅ", u"ㄹㅌ", u"ㄹㅍ", u"ㄹㅎ", u"ㅁ",   u"ㅂ", u"ㅂㅅ", u"ㅅ",
    u"ㅅㅅ", u"ㅇ",   u"ㅈ",   u"ㅊ",   u"ㅋ",   u"ㅌ",   u"ㅍ",   u"ㅎ"};
/// Jamo that are typed as one and taken apart, from U+3131.
constexpr std::array jamo_pairs{
    Pair{U'ㄲ', u"ㄱㄱ"}, Pair{U'ㄳ', u"ㄱㅅ"}, Pair{U'ㄵ', u"ㄴㅈ"}, Pair{U'ㄶ', u"ㄴㅎ"},
    Pair{U'ㄸ', u"ㄷㄷ"}, Pair{U'ㄺ', u"ㄹㄱ"}, Pair{U'ㄻ', u"ㄹㅁ"}, Pair{U'ㄼ', u"ㄹㅂ"},
    Pair{U'ㄽ', u"ㄹㅅ"}, Pair{U'ㄾ', u"ㄹㅌ"}, Pair{U'ㄿ', u"ㄹㅍ"}, Pair{U'ㅀ', u"ㄹㅎ"},
    Pair{U'ㅃ', u"ㅂㅂ"}, Pair{U'ㅄ', u"ㅂㅅ"}, Pair{U'ㅆ', u"ㅅㅅ"}, Pair{U'ㅉ', u"ㅈㅈ"},
    Pair{U'ㅒ', u"ㅑㅣ"}, Pair{U'ㅖ', u"ㅕㅣ"}, Pair{U'ㅘ', u"ㅗㅏ"}, Pair{U'ㅙ', u"ㅗㅐ"},
    Pair{U'ㅚ', u"ㅗㅣ"}, Pair{U'ㅝ', u"ㅜㅓ"}, Pair{U'ㅞ', u"ㅜㅔ"}, Pair{U'ㅟ', u"ㅜㅣ"},
    Pair{U'ㅢ', u"ㅡㅣ"},
};

Folded syllable(char32_t letter) noexcept {
  const auto index = static_cast<std::size_t>(letter - first_syllable);
  Folded folded;
  for (const std::u16string_view part :
       {lead_keys[index / 588], vowel_keys[index % 588 / 28], tail_keys[index % 28]})
    for (const char16_t jamo : part) folded.letters[folded.count++] = jamo;
  return folded;
}

}  // namespace

Folded fold(char32_t letter) noexcept {
  if (letter >= U'a' && letter <= U'z') return just(static_cast<char16_t>(letter));
  if (letter >= U'0' && letter <= U'9') return just(static_cast<char16_t>(letter));
  if (letter >= U'A' && letter <= U'Z') return just(static_cast<char16_t>(letter - U'A' + U'a'));
  if (letter >= U'\uFF01' && letter <= U'\uFF5E') return fold(letter - U'\uFF01' + U'!');
  if (among(silent, letter)) return {};
  if (among(gaps, letter)) return just(u' ');
  for (const char32_t zero : zeros)
    if (letter >= zero && letter < zero + 10)
      return just(static_cast<char16_t>(letter - zero + U'0'));
  if (is_syllable(letter)) return syllable(letter);
  for (const std::span<const Pair> table :
       {std::span<const Pair>(pairs), std::span<const Pair>(jamo_pairs)})
    if (const auto found = std::ranges::find(table, letter, &Pair::from); found != table.end())
      return these(found->to);
  if (letter >= U'\u30A1' && letter <= U'\u30F6') letter -= U'\u30A1' - U'\u3041';
  if (letter >= U'А' && letter <= U'Я') return just(static_cast<char16_t>(letter + 0x20));
  for (const LetterRow& row : letter_rows)
    if (letter >= row.first && letter < row.first + row.to.size())
      if (const char16_t to = row.to[letter - row.first]; to != unchanged) return just(to);
  // The rarest signs, which nobody types, are told apart well enough by what is left of them.
  return just(static_cast<char16_t>(letter));
}

Decoded decode(std::string_view text) noexcept {
  const auto byte = [&](std::size_t i) {
    return static_cast<char32_t>(static_cast<unsigned char>(text[i]));
  };
  const char32_t lead = byte(0);
  const std::size_t length = lead < 0x80 ? 1 : lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
  if (length == 1) return {lead, 1};
  if (length > text.size() || lead < 0xC0) return {U'\uFFFD', 1};
  char32_t letter = lead & (0xFFU >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) letter = letter << 6U | (byte(i) & 0x3FU);
  return {letter, length};
}

std::u16string folded(std::string_view text) {
  std::u16string out;
  while (!text.empty()) {
    const auto [letter, length] = decode(text);
    append(out, fold(letter));
    text.remove_prefix(length);
  }
  return trimmed(std::move(out));
}

std::u16string folded(std::u16string_view typed) {
  std::u16string out;
  for (const char16_t letter : typed) append(out, fold(letter));
  return trimmed(std::move(out));
}

void append(std::u16string& out, const Folded& letters) {
  for (std::size_t i = 0; i < letters.count; ++i) {
    const bool is_gap = letters.letters[i] == u' ';
    if (!is_gap || (!out.empty() && out.back() != u' ')) out += letters.letters[i];
  }
}

std::u16string trimmed(std::u16string text) {
  if (text.ends_with(u' ')) text.pop_back();
  return text;
}

}  // namespace docent::search
