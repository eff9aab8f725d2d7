#include "runtime/interface/keyboard.h"

#include <algorithm>

#include "runtime/search/compose.h"

namespace docent::interface {
namespace {

constexpr std::array keyboards{
    Keyboard{"en", {u"qwertyuiop", u"asdfghjkl", u"zxcvbnm"}},
    Keyboard{"zh", {u"qwertyuiop", u"asdfghjkl", u"zxcvbnm"}},
    Keyboard{"de", {u"qwertzuiop", u"asdfghjkl", u"yxcvbnmß"}},
    Keyboard{"fr", {u"azertyuiop", u"qsdfghjklm", u"wxcvbn"}},
    Keyboard{"es", {u"qwertyuiop", u"asdfghjklñ", u"zxcvbnm"}},
    Keyboard{"ru", {u"йцукенгшщзх", u"фывапролджэ", u"ячсмитьбюъё"}},
    Keyboard{"ar", {u"ضصثقفغعهخحج", u"شسيبلاتنمكط", u"ذءؤرىةوزظد"}},
    Keyboard{"he", {u"קראטוןםפ", u"שדגכעיחלךף", u"זסבהנמצתץ"}},
    Keyboard{"ko", {u"ㅂㅈㄷㄱㅅㅛㅕㅑㅐㅔ", u"ㅁㄴㅇㄹㅎㅗㅓㅏㅣ", u"ㅋㅌㅊㅍㅠㅜㅡ"}},
    Keyboard{"ja",
             {u"わらやまはなたさかあ", u"をりゃみひにちしきい", u"んるゆむふぬつすくう",
              u"ーれゅめへねてせけえ", u"゛ろよもほのとそこお", u"っょ゜"}},
    Keyboard{
        "hi",
        {u"अआइईउऊएऐओऔ", u"कखगघङचछजझञ", u"टठडढणतथदधन", u"पफबभमयरलवश", u"षसहऋ\u0902\u0901\u094D"}},
    Keyboard{"th",
             {u"กขคฆงจฉชซฌ", u"ญฎฏฐฑฒณดตถ", u"ทธนบปผฝพฟภ", u"มยรลวศษสหฬ",
              u"อฮะ\u0E31า\u0E33\u0E34\u0E35\u0E36\u0E37", u"\u0E38\u0E39เแโใไฤ"}},
};

/// What signs and jamo are called, which cannot be said by themselves.
struct Name {
  char16_t letter;
  std::string_view said;
};
constexpr std::array names{
    Name{u'ㄱ', "기역"},         Name{u'ㄴ', "니은"},
    Name{u'ㄷ', "디귿"},         Name{u'ㄹ', "리을"},
    Name{u'ㅁ', "미음"},         Name{u'ㅂ', "비읍"},
    Name{u'ㅅ', "시옷"},         Name{u'ㅇ', "이응"},
    Name{u'ㅈ', "지읒"},         Name{u'ㅊ', "치읓"},
    Name{u'ㅋ', "키읔"},         Name{u'ㅌ', "티읕"},
    Name{u'ㅍ', "피읖"},         Name{u'ㅎ', "히읗"},
    Name{u'ㅏ', "아"},           Name{u'ㅐ', "애"},
    Name{u'ㅑ', "야"},           Name{u'ㅓ', "어"},
    Name{u'ㅔ', "에"},           Name{u'ㅕ', "여"},
    Name{u'ㅗ', "오"},           Name{u'ㅛ', "요"},
    Name{u'ㅜ', "우"},           Name{u'ㅠ', "유"},
    Name{u'ㅡ', "으"},           Name{u'ㅣ', "이"},
    Name{u'ゃ', "や"},           Name{u'ゅ', "ゆ"},
    Name{u'ょ', "よ"},           Name{u'っ', "つ"},
    Name{u'ー', "ちょうおん"},   Name{u'゛', "だくてん"},
    Name{u'゜', "はんだくてん"}, Name{u'\u0902', "अनुस्वार"},
    Name{u'\u0901', "चंद्रबिंदु"},   Name{u'\u094D', "हलंत"},
    Name{u'ь', "мягкий знак"},   Name{u'ъ', "твёрдый знак"},
    Name{u'ء', "همزة"},          Name{u'ؤ', "واو همزة"},
    Name{u'ى', "ألف مقصورة"},    Name{u'ة', "تاء مربوطة"},
    Name{u'ะ', "สระอะ"},         Name{u'\u0E31', "ไม้หันอากาศ"},
    Name{u'า', "สระอา"},         Name{u'\u0E33', "สระอำ"},
    Name{u'\u0E34', "สระอิ"},     Name{u'\u0E35', "สระอี"},
    Name{u'\u0E36', "สระอึ"},     Name{u'\u0E37', "สระอือ"},
    Name{u'\u0E38', "สระอุ"},     Name{u'\u0E39', "สระอู"},
    Name{u'เ', "สระเอ"},         Name{u'แ', "สระแอ"},
    Name{u'โ', "สระโอ"},         Name{u'ใ', "ใอไม้ม้วน"},
    Name{u'ไ', "ไอไม้มลาย"},
};

/// Signs that stand on a letter.
bool needs_a_letter(char16_t letter) noexcept {
  const bool is_devanagari = letter == 0x0901 || letter == 0x0902 || letter == 0x094D;
  const bool is_thai = letter == 0x0E31 || (letter >= 0x0E34 && letter <= 0x0E39);
  return is_devanagari || is_thai;
}

}  // namespace

std::size_t Keyboard::row_count() const noexcept {
  return static_cast<std::size_t>(
      std::ranges::count_if(rows, [](std::u16string_view row) { return !row.empty(); }));
}

const Keyboard& keyboard_of(std::string_view tag) noexcept {
  const std::string_view language = tag.substr(0, tag.find('-'));
  const auto found = std::ranges::find(keyboards, language, &Keyboard::language);
  return found == keyboards.end() ? keyboards.front() : *found;
}

std::string label_of(char16_t letter) {
  if (letter >= u'a' && letter <= u'z') letter = static_cast<char16_t>(letter - u'a' + u'A');
  if (letter >= u'а' && letter <= u'я') letter = static_cast<char16_t>(letter - 0x20);
  if (letter == u'ё') letter = u'Ё';
  if (letter == u'ñ') letter = u'Ñ';
  constexpr char16_t any_letter = u'\u25CC';  // a dotted circle
  return needs_a_letter(letter) ? search::utf8_of(any_letter) + search::utf8_of(letter)
                                : search::utf8_of(letter);
}

std::string said_of(char16_t letter) {
  const auto name = std::ranges::find(names, letter, &Name::letter);
  return name == names.end() ? search::utf8_of(letter) : std::string(name->said);
}

}  // namespace docent::interface
